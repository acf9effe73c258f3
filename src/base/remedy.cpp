#include "base/remedy.h"

#include <cerrno>

namespace tumble {

const char* remedy(int error) {
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        return "free some space, or write to another disk";
    case ENOTDIR:
    case EEXIST:
        return "a file is in the way: move it, or name another place";
    case EISDIR:
        return "a folder has this name: name another place";
    case ENOENT:
    case EACCES:
    case EPERM:
    case EROFS:
        return "name a place in a folder that is there and where you may write";
    default:
        return "";
    }
}

} // namespace tumble
