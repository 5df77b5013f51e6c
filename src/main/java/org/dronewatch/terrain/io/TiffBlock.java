package org.dronewatch.terrain.io;

import com.twelvemonkeys.imageio.plugins.tiff.TIFFImageReaderSpi;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/**
 * Decodes the strips or tiles of a TIFF file one at a time with TwelveMonkeys ImageIO: each is handed over as a small
 * TIFF file of a single strip. Thus only what is needed is decoded, a missing tile is a hole and not an error, and
 * nothing else that a damaged file may state reaches the library.
 *
 * @param order byte order of the file
 * @param bits number of bits in a sample: 8, 16, 32 or 64
 * @param format format of a sample: 1 unsigned, 2 signed, 3 real
 * @param compression compression, by its number in TIFF
 * @param predictor predictor, by its number in TIFF
 */
record TiffBlock(ByteOrder order, int bits, int format, int compression, int predictor) {
    private static final int SHORT = 3;
    private static final int LONG = 4;
    private static final int ENTRIES = 11;
    private static final int HEADER = 8 + 2 + 12 * ENTRIES + 4;

    static final int SIGNED = 2;

    static final int REAL = 3;

    /**
     * The samples of a block, row by row.
     *
     * @throws IOException when they cannot be decoded
     */
    double[] decode(byte[] compressed, int columns, int rows) throws IOException {
        byte[] file = file(compressed, columns, rows);
        ImageReader reader = new TIFFImageReaderSpi().createReaderInstance(null);
        try (ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(file))) {
            reader.setInput(in);
            return samples(reader.readRaster(0, null), columns, rows);
        } catch (RuntimeException e) {
            // What the decoders throw at damaged data: indices out of range, negative sizes.
            throw new IOException(String.valueOf(e.getMessage()), e);
        } finally {
            reader.dispose();
        }
    }

    private double[] samples(Raster raster, int columns, int rows) throws IOException {
        DataBuffer data = raster.getDataBuffer();
        int count = columns * rows;
        if (raster.getWidth() != columns || raster.getHeight() != rows || data.getSize() < count) {
            throw new IOException("the decoder gives " + raster.getWidth() + " x " + raster.getHeight() + " samples");
        }
        double[] samples = new double[count];
        for (int i = 0; i < count; i++) {
            samples[i] = format == REAL ? data.getElemDouble(i) : whole(data.getElem(i));
        }
        return samples;
    }

    /** A whole number as the file means it, whichever way the decoder keeps it. */
    private double whole(int stored) {
        if (format == SIGNED) {
            return bits == 8 ? (byte) stored : bits == 16 ? (short) stored : stored;
        }
        return bits == 8 ? stored & 0xFF : bits == 16 ? stored & 0xFFFF : Integer.toUnsignedLong(stored);
    }

    private byte[] file(byte[] compressed, int columns, int rows) {
        ByteBuffer file = ByteBuffer.allocate(HEADER + compressed.length).order(order);
        file.put(order == ByteOrder.LITTLE_ENDIAN ? new byte[] {'I', 'I'} : new byte[] {'M', 'M'});
        file.putShort((short) 42).putInt(8);
        file.putShort((short) ENTRIES);
        put(file, 256, LONG, columns);
        put(file, 257, LONG, rows);
        put(file, 258, SHORT, bits);
        put(file, 259, SHORT, compression);
        put(file, 262, SHORT, 1);
        put(file, 273, LONG, HEADER);
        put(file, 277, SHORT, 1);
        put(file, 278, LONG, rows);
        put(file, 279, LONG, compressed.length);
        put(file, 317, SHORT, predictor);
        put(file, 339, SHORT, format);
        file.putInt(0);
        file.put(compressed);
        return file.array();
    }

    private static void put(ByteBuffer file, int tag, int type, int value) {
        file.putShort((short) tag).putShort((short) type).putInt(1);
        if (type == SHORT) {
            file.putShort((short) value).putShort((short) 0);
        } else {
            file.putInt(value);
        }
    }
}
