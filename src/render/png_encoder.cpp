#include "render/png_encoder.hpp"

#include <png.h>

#include <array>
#include <csetjmp>
#include <exception>
#include <string>
#include <utility>

namespace eliminant::render {

// libpng reports an error by calling back, and the callback must not return. It jumps to the frame of
// guarded(), which throws. Two rules keep that defined: between the jump and its landing there are only
// frames of libpng and functions of ours without objects that have a destructor; and no exception of the sink
// passes through libpng, which is C: it waits in the State.
struct PngEncoder::State {
    State(ImageSize picture, ByteSink bytes) : size(picture), sink(std::move(bytes)) {}
    ~State() { png_destroy_write_struct(&png, &info); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    /// Calls `body(state, data)`, which may be left by a jump.
    using Body = void (*)(State&, const std::uint8_t* data);
    void guarded(Body body, const std::uint8_t* data = nullptr) {
        if (!returns(body, data)) {
            if (thrown) std::rethrow_exception(std::exchange(thrown, nullptr));
            throw EncodingError("PNG: " + std::string(message.data()));
        }
    }

    ImageSize size;
    ByteSink sink;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::exception_ptr thrown = {};
    std::array<char, 128> message{};

  private:
    bool returns(Body body, const std::uint8_t* data) noexcept {
        if (setjmp(png_jmpbuf(png)) != 0) return false;
        body(*this, data);
        return true;
    }
};

namespace {

/// Passes bytes to the sink of a State. False if it threw, which the State then holds.
template <class State>
bool delivered(State& state, const char* bytes, std::size_t count) noexcept {
    try {
        state.sink({bytes, count});
        return true;
    } catch (...) {
        state.thrown = std::current_exception();
        return false;
    }
}

template <class State>
void on_bytes(png_structp png, png_bytep bytes, png_size_t count) {
    State& state = *static_cast<State*>(png_get_io_ptr(png));
    if (!delivered(state, reinterpret_cast<const char*>(bytes), count)) png_error(png, "not written");
}

void on_flush(png_structp) {}

template <class State>
[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    State& state = *static_cast<State*>(png_get_error_ptr(png));
    std::size_t length = 0;
    for (; message[length] != '\0' && length + 1 < state.message.size(); ++length)
        state.message[length] = message[length];
    state.message[length] = '\0';
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

} // namespace

PngEncoder::PngEncoder(ImageSize size, ByteSink sink)
    : state_(std::make_unique<State>(size, std::move(sink))) {
    state_->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, state_.get(), on_error<State>, on_warning);
    state_->info = state_->png == nullptr ? nullptr : png_create_info_struct(state_->png);
    if (state_->info == nullptr) throw EncodingError("PNG: libpng cannot be initialised");
    state_->guarded([](State& state, const std::uint8_t*) {
        png_set_write_fn(state.png, &state, on_bytes<State>, on_flush);
        png_set_user_limits(state.png, most_pixels_a_side, most_pixels_a_side);
        png_set_IHDR(state.png, state.info, state.size.width, state.size.height, 8, PNG_COLOR_TYPE_RGB,
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_sRGB(state.png, state.info, PNG_sRGB_INTENT_PERCEPTUAL);
        png_write_info(state.png, state.info);
    });
}

PngEncoder::~PngEncoder() = default;

void PngEncoder::write_rows(std::span<const std::uint8_t> bytes) {
    const std::size_t row = 3 * std::size_t{state_->size.width};
    for (; !bytes.empty(); bytes = bytes.subspan(row))
        state_->guarded([](State& state, const std::uint8_t* data) { png_write_row(state.png, data); },
                        bytes.data());
}

void PngEncoder::finish() {
    state_->guarded([](State& state, const std::uint8_t*) { png_write_end(state.png, nullptr); });
}

} // namespace eliminant::render
