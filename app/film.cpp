#include "app/film.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/program_search.h"

namespace hazer::app {
namespace {

std::vector<std::string> encoderArguments(const FilmFormat& format, const std::filesystem::path& file) {
    return {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24",
            "-video_size", fmt::format("{}x{}", format.width, format.height), "-framerate",
            fmt::format("{}", format.framesPerS), "-i", "-", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf",
            "18", "-movflags", "+faststart",
            // A name that begins with a dash, or holds a colon, is still a file.
            "file:" + file.string()};
}

}  // namespace

bool canMakeFilms() {
    return findProgram("ffmpeg").has_value();
}

/// The ffmpeg process and the socket into it. A socket and not a pipe, as writing into a pipe that nobody
/// reads ends the whole program by a signal.
struct Film::Encoder {
    pid_t process = -1;
    int input = -1;

    Encoder(const std::filesystem::path& program, std::vector<std::string> arguments) {
        std::array<int, 2> ends{};
        // Closed on exec, or the encoder would hold its own input open and never see the end of it.
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
            throw std::runtime_error("no connection to ffmpeg could be made");
        }
        std::vector<char*> pointers;
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        pointers.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
        const int error = posix_spawn(&process, program.c_str(), &actions, nullptr, pointers.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        close(ends[0]);
        input = ends[1];
        if (error == 0) return;
        close(input);
        throw std::runtime_error(
            fmt::format("{} cannot be started: {}", program.string(), std::strerror(error)));
    }

    ~Encoder() { wait(); }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    bool write(const std::uint8_t* bytes, std::size_t count) const {
        while (count > 0) {
            const ssize_t written = send(input, bytes, count, MSG_NOSIGNAL);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) return false;
            bytes += written;
            count -= static_cast<std::size_t>(written);
        }
        return true;
    }

    /// Ends the input and gives ffmpeg's exit status; 0 if it has been asked before.
    int wait() {
        if (process < 0) return 0;
        close(input);
        int status = 0;
        waitpid(std::exchange(process, -1), &status, 0);
        return status;
    }
};

Film::Film(std::filesystem::path file, const FilmFormat& format)
    : file_(std::move(file)), unfinished_(file_) {
    const std::optional<std::filesystem::path> program = findProgram("ffmpeg");
    if (!program) {
        throw std::runtime_error(
            fmt::format("{}: a film needs the ffmpeg program, which is not on PATH; install it, or write "
                        "numbered .png frames",
                        file_.string()));
    }
    if (format.width % 2 != 0 || format.height % 2 != 0) {
        throw std::runtime_error(fmt::format("{}: a film needs an even width and height, not {}x{}",
                                             file_.string(), format.width, format.height));
    }
    unfinished_.replace_filename("." + file_.stem().string() + ".unfinished" + file_.extension().string());
    encoder_ = std::make_unique<Encoder>(*program, encoderArguments(format, unfinished_));
}

Film::~Film() {
    if (encoder_ == nullptr) return;
    encoder_.reset();
    std::error_code ignored;
    std::filesystem::remove(unfinished_, ignored);
}

void Film::add(const render::ByteImage& picture) {
    if (encoder_->write(picture.rgb.data(), picture.rgb.size())) return;
    throw std::runtime_error(fmt::format(
        "{}: ffmpeg has ended before the film; is there room, and may it write there?", file_.string()));
}

void Film::finish() {
    const int status = encoder_->wait();
    if (status != 0) {
        throw std::runtime_error(fmt::format(
            "{}: ffmpeg could not write the film; is there room, and may it write there?", file_.string()));
    }
    std::error_code error;
    std::filesystem::rename(unfinished_, file_, error);
    if (error) {
        throw std::runtime_error(
            fmt::format("{}: the finished film cannot be put there: {}; give another --out", file_.string(),
                        error.message()));
    }
    encoder_.reset();
}

}  // namespace hazer::app
