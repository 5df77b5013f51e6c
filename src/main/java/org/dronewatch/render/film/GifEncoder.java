package org.dronewatch.render.film;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOInvalidTreeException;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * Encodes images as a GIF that loops forever, for pages that show pictures but no videos. Each frame has its own
 * palette of up to 256 colours and stores only the pixels that changed since the previous frame, so a static background
 * takes almost no space.
 */
final class GifEncoder implements FilmEncoder {
    private static final String FORMAT = "gif";
    private static final int OPAQUE = 0xff000000;
    /** GIF states the duration of a frame in hundredths of a second. */
    private static final int HUNDREDTHS = 100;

    private final ImageWriter writer =
            ImageIO.getImageWritersByFormatName(FORMAT).next();
    private final MemoryCacheImageOutputStream out;
    private final int fps;
    private int[] before;
    private int frames;

    /** Begins a film in an empty file. */
    GifEncoder(FileChannel file, int fps) throws IOException {
        this.fps = fps;
        this.out = new MemoryCacheImageOutputStream(Channels.newOutputStream(file));
        writer.setOutput(out);
        writer.prepareWriteSequence(null);
    }

    @Override
    public void add(BufferedImage image) throws IOException {
        Film.checkSize(image.getWidth(), image.getHeight());
        BufferedImage frame = indexed(changes(image));
        ImageTypeSpecifier type = new ImageTypeSpecifier(frame);
        writer.writeToSequence(
                new IIOImage(frame, null, metadata(type, (IndexColorModel) frame.getColorModel())),
                writer.getDefaultWriteParam());
        frames++;
    }

    /** The image without the pixels that are the same as in the previous frame; these are transparent. */
    private BufferedImage changes(BufferedImage image) {
        int width = image.getWidth();
        int height = image.getHeight();
        int[] now = image.getRGB(0, 0, width, height, null, 0, width);
        int[] changed = new int[now.length];
        for (int i = 0; i < now.length; i++) {
            changed[i] = before == null || now[i] != before[i] ? now[i] | OPAQUE : 0;
        }
        before = now;
        BufferedImage changes = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        changes.setRGB(0, 0, width, height, changed, 0, width);
        return changes;
    }

    /** The image with the colours that the library chooses for it: it does so only on writing. */
    private static BufferedImage indexed(BufferedImage image) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ImageIO.write(image, FORMAT, bytes);
        return ImageIO.read(new ByteArrayInputStream(bytes.toByteArray()));
    }

    private IIOMetadata metadata(ImageTypeSpecifier type, IndexColorModel colours) throws IIOInvalidTreeException {
        IIOMetadata metadata = writer.getDefaultImageMetadata(type, writer.getDefaultWriteParam());
        String format = metadata.getNativeMetadataFormatName();
        IIOMetadataNode root = (IIOMetadataNode) metadata.getAsTree(format);
        IIOMetadataNode control = child(root, "GraphicControlExtension");
        int transparent = colours.getTransparentPixel();
        control.setAttribute("disposalMethod", "doNotDispose");
        control.setAttribute("userInputFlag", "FALSE");
        control.setAttribute("transparentColorFlag", transparent >= 0 ? "TRUE" : "FALSE");
        control.setAttribute("transparentColorIndex", Integer.toString(Math.max(0, transparent)));
        control.setAttribute("delayTime", Integer.toString(ends(frames + 1) - ends(frames)));
        if (frames == 0) {
            IIOMetadataNode endless = new IIOMetadataNode("ApplicationExtension");
            endless.setAttribute("applicationID", "NETSCAPE");
            endless.setAttribute("authenticationCode", "2.0");
            endless.setUserObject(new byte[] {1, 0, 0});
            child(root, "ApplicationExtensions").appendChild(endless);
        }
        metadata.setFromTree(format, root);
        return metadata;
    }

    /**
     * The time at which a number of frames have been shown, in hundredths of a second: rounding errors must not add up.
     */
    private int ends(int shown) {
        return Math.round((float) HUNDREDTHS * shown / fps);
    }

    private static IIOMetadataNode child(IIOMetadataNode root, String name) {
        for (int i = 0; i < root.getLength(); i++) {
            if (root.item(i).getNodeName().equals(name)) {
                return (IIOMetadataNode) root.item(i);
            }
        }
        IIOMetadataNode child = new IIOMetadataNode(name);
        root.appendChild(child);
        return child;
    }

    @Override
    public void finish() throws IOException {
        writer.endWriteSequence();
        out.flush();
        writer.dispose();
    }
}
