package org.dronewatch.render.film;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import org.jcodec.codecs.h264.H264Encoder;
import org.jcodec.codecs.h264.encode.DumbRateControl;
import org.jcodec.codecs.h264.io.model.SeqParameterSet;
import org.jcodec.codecs.h264.io.model.VUIParameters;
import org.jcodec.common.Codec;
import org.jcodec.common.MuxerTrack;
import org.jcodec.common.VideoCodecMeta;
import org.jcodec.common.VideoEncoder;
import org.jcodec.common.io.FileChannelWrapper;
import org.jcodec.common.model.ColorSpace;
import org.jcodec.common.model.Packet;
import org.jcodec.common.model.Picture;
import org.jcodec.common.model.Size;
import org.jcodec.containers.mp4.boxes.MediaHeaderBox;
import org.jcodec.containers.mp4.boxes.MovieBox;
import org.jcodec.containers.mp4.boxes.MovieHeaderBox;
import org.jcodec.containers.mp4.boxes.NodeBox;
import org.jcodec.containers.mp4.boxes.TrackHeaderBox;
import org.jcodec.containers.mp4.boxes.TrakBox;
import org.jcodec.containers.mp4.muxer.MP4Muxer;
import org.jcodec.scale.AWTUtil;
import org.jcodec.scale.RgbToYuv420p;

/** Encodes images as an MP4 video, H.264 at constant quality. The same images give the same bytes. Not thread-safe. */
final class Mp4Encoder implements FilmEncoder {
    /** Interval between key frames, in frames, so that players can seek. */
    private static final int KEY_INTERVAL = 25;

    private final MP4Muxer muxer;
    private final int fps;
    private final H264Encoder encoder = new ColouredEncoder();
    private final RgbToYuv420p colours = new RgbToYuv420p();
    private MuxerTrack track;
    private Picture yuv;
    private ByteBuffer buffer;
    private int frames;

    /** Begins a film in an empty file that is open for writing and reading. */
    Mp4Encoder(FileChannel file, int fps) throws IOException {
        this.fps = fps;
        this.muxer = MP4Muxer.createMP4MuxerToChannel(new FileChannelWrapper(file));
        encoder.setKeyInterval(KEY_INTERVAL);
    }

    /** {@inheritDoc} If a side has an odd number of pixels, its last row or column is repeated. */
    @Override
    public void add(BufferedImage image) throws IOException {
        BufferedImage even = even(image);
        if (track == null) {
            begin(even.getWidth(), even.getHeight());
        }
        colours.transform(AWTUtil.fromBufferedImageRGB(even), yuv);
        buffer.clear();
        VideoEncoder.EncodedFrame frame = encoder.encodeFrame(yuv, buffer);
        Packet.FrameType type = frame.isKeyFrame() ? Packet.FrameType.KEY : Packet.FrameType.INTER;
        track.addFrame(Packet.createPacket(frame.getData(), frames, fps, 1, frames, type, null));
        frames++;
    }

    private void begin(int width, int height) {
        Film.checkSize(width, height);
        // The encoder accepts only images with this label; their levels are 16 to 235, as the stream declares.
        yuv = Picture.create(width, height, ColorSpace.YUV420J);
        buffer = ByteBuffer.allocate(encoder.estimateBufferSize(yuv));
        track = muxer.addVideoTrack(
                Codec.H264, VideoCodecMeta.createSimpleVideoCodecMeta(new Size(width, height), ColorSpace.YUV420J));
    }

    /** H.264 halves the resolution of colours: an odd side repeats its last column or row. */
    private static BufferedImage even(BufferedImage image) {
        int width = image.getWidth() + image.getWidth() % 2;
        int height = image.getHeight() + image.getHeight() % 2;
        if (width == image.getWidth() && height == image.getHeight()) {
            return image;
        }
        BufferedImage even = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                even.setRGB(
                        column,
                        row,
                        image.getRGB(Math.min(column, image.getWidth() - 1), Math.min(row, image.getHeight() - 1)));
            }
        }
        return even;
    }

    /** {@inheritDoc} The film's dates are those of 1970: the same film is the same file whenever it is made. */
    @Override
    public void finish() throws IOException {
        MovieBox movie = muxer.finalizeHeader();
        MovieHeaderBox head = NodeBox.findFirst(movie, MovieHeaderBox.class, MovieHeaderBox.fourcc());
        movie.replaceBox(MovieHeaderBox.createMovieHeaderBox(
                head.getTimescale(),
                head.getDuration(),
                head.getRate(),
                head.getVolume(),
                0L,
                0L,
                head.getMatrix(),
                head.getNextTrackId()));
        for (TrakBox trak : movie.getTracks()) {
            undate(trak);
        }
        muxer.storeHeader(movie);
    }

    private static void undate(TrakBox trak) {
        TrackHeaderBox old = trak.getTrackHeader();
        TrackHeaderBox undated = TrackHeaderBox.createTrackHeaderBox(
                old.getTrackId(),
                old.getDuration(),
                old.getWidth(),
                old.getHeight(),
                0L,
                0L,
                old.getVolume(),
                old.getLayer(),
                old.getAltGroup(),
                old.getMatrix());
        undated.setFlags(old.getFlags());
        trak.replaceBox(undated);
        MediaHeaderBox media = NodeBox.findFirst(trak.getMdia(), MediaHeaderBox.class, MediaHeaderBox.fourcc());
        trak.getMdia()
                .replaceBox(MediaHeaderBox.createMediaHeaderBox(
                        media.getTimescale(), media.getDuration(), media.getLanguage(), 0L, 0L, media.getQuality()));
    }

    /** States the colour space in the stream: otherwise players guess it from the size of the picture. */
    private static final class ColouredEncoder extends H264Encoder {
        private static final int UNSPECIFIED = 5;
        private static final int BT709 = 1;
        private static final int BT601 = 6;

        ColouredEncoder() {
            super(new DumbRateControl());
        }

        @Override
        public SeqParameterSet initSPS(Size size) {
            SeqParameterSet parameters = super.initSPS(size);
            VUIParameters colours = new VUIParameters();
            colours.videoSignalTypePresentFlag = true;
            colours.videoFormat = UNSPECIFIED;
            colours.videoFullRangeFlag = false;
            colours.colourDescriptionPresentFlag = true;
            colours.colourPrimaries = BT709;
            colours.transferCharacteristics = BT709;
            colours.matrixCoefficients = BT601;
            parameters.vuiParams = colours;
            return parameters;
        }
    }
}
