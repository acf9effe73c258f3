#include "cli/program.h"

int main(int count, char** words) {
    return tumble::cli::run_program(count, words);
}
