package org.dronewatch.render;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jcodec.api.FrameGrab;
import org.jcodec.api.JCodecException;
import org.jcodec.common.io.FileChannelWrapper;
import org.jcodec.common.io.NIOUtils;
import org.jcodec.common.model.Picture;
import org.jcodec.scale.AWTUtil;

/** Plays films back. */
public final class Films {
    private Films() {}

    /** All frames of an MP4 file, decoded. */
    public static List<BufferedImage> frames(Path file) throws IOException, JCodecException {
        List<BufferedImage> frames = new ArrayList<>();
        try (FileChannelWrapper channel = NIOUtils.readableChannel(file.toFile())) {
            FrameGrab grab = FrameGrab.createFrameGrab(channel);
            for (Picture picture = grab.getNativeFrame(); picture != null; picture = grab.getNativeFrame()) {
                frames.add(AWTUtil.toBufferedImage(picture));
            }
        }
        return frames;
    }

    /** The mean difference of two pictures of one size over their pixels and colours, 0 to 255. */
    public static double difference(BufferedImage one, BufferedImage other) {
        long sum = 0;
        for (int row = 0; row < one.getHeight(); row++) {
            for (int column = 0; column < one.getWidth(); column++) {
                for (int shift = 0; shift <= 16; shift += 8) {
                    sum += Math.abs(
                            (one.getRGB(column, row) >> shift & 255) - (other.getRGB(column, row) >> shift & 255));
                }
            }
        }
        return sum / (3.0 * one.getWidth() * one.getHeight());
    }
}
