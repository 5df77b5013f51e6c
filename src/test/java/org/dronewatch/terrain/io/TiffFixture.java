package org.dronewatch.terrain.io;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.Deflater;

/**
 * Writes small GeoTIFF files in many ways (TIFF revision 6.0 and its supplements 1 and 3), without the library that
 * reads them. LZW is written with a clear code after every 250 literals, so that codes stay 9 bits long.
 */
public final class TiffFixture {
    private static final int SHORT = 3;
    private static final int LONG = 4;
    private static final int DOUBLE = 12;
    private static final int LONG8 = 16;

    public final int columns;
    public final int rows;
    public final double[] samples;

    public ByteOrder order = ByteOrder.LITTLE_ENDIAN;
    public boolean big;
    public int bits = 32;
    public int format = 3;
    public int compression = 1;
    public int predictor = 1;
    public int tile;
    public int stripRows = 7;
    public int missingBlock = -1;
    public String nodata = "";
    public String metadata = "";
    public double[] scale = {10, 10, 0};
    public double[] tie = {0, 0, 0, 500_000, 5_000_000, 0};
    public double[] matrix = {};

    /** GeoKeys by number; a code of 0 leaves a key out. */
    public final Map<Integer, Integer> keys = new TreeMap<>(Map.of(1024, 1, 1025, 1, 3072, 32633));

    /** Tags that replace those that are written, by number: type SHORT or LONG, one value. */
    public final Map<Integer, Long> lies = new TreeMap<>();

    /** Zeros that follow the samples of each block before it is packed. */
    public int padding;

    /** A file of these samples, row by row. */
    public TiffFixture(int columns, int rows, double[] samples) {
        this.columns = columns;
        this.rows = rows;
        this.samples = samples;
    }

    private record Tag(int type, long count, byte[] bytes) {}

    /** The file. */
    public byte[] bytes() {
        List<byte[]> blocks = blocks();
        Map<Integer, Tag> tags = new TreeMap<>();
        tags.put(256, numbers(LONG, columns));
        tags.put(257, numbers(LONG, rows));
        tags.put(258, numbers(SHORT, bits));
        tags.put(259, numbers(SHORT, compression));
        tags.put(262, numbers(SHORT, 1));
        tags.put(277, numbers(SHORT, 1));
        if (tile > 0) {
            tags.put(322, numbers(LONG, tile));
            tags.put(323, numbers(LONG, tile));
        } else {
            tags.put(278, numbers(LONG, stripRows));
        }
        if (predictor > 1) {
            tags.put(317, numbers(SHORT, predictor));
        }
        tags.put(339, numbers(SHORT, format));
        if (matrix.length > 0) {
            tags.put(34264, doubles(matrix));
        } else if (scale.length > 0) {
            tags.put(33550, doubles(scale));
            tags.put(33922, doubles(tie));
        }
        tags.put(34735, keyDirectory());
        if (!nodata.isEmpty()) {
            tags.put(42113, text(nodata));
        }
        if (!metadata.isEmpty()) {
            tags.put(42112, text(metadata));
        }
        long[] lengths = blocks.stream().mapToLong(block -> block.length).toArray();
        tags.put(tile > 0 ? 325 : 279, numbers(big ? LONG8 : LONG, lengths));
        tags.put(tile > 0 ? 324 : 273, numbers(big ? LONG8 : LONG, lengths));
        lies.forEach((tag, value) -> tags.put(tag, numbers(LONG, value)));
        return put(tags, blocks);
    }

    private byte[] put(Map<Integer, Tag> tags, List<byte[]> blocks) {
        int inside = big ? 8 : 4;
        int entry = big ? 20 : 12;
        int start = big ? 16 : 8;
        int header = start + (big ? 8 : 2) + entry * tags.size() + inside;
        int after = header;
        for (Tag tag : tags.values()) {
            after += tag.bytes().length > inside ? tag.bytes().length : 0;
        }
        int total = after + blocks.stream().mapToInt(block -> block.length).sum();
        // Offsets are known now.
        int offsetTag = tile > 0 ? 324 : 273;
        long[] offsets = new long[blocks.size()];
        int at = after;
        for (int i = 0; i < offsets.length; i++) {
            offsets[i] = blocks.get(i).length == 0 ? 0 : at;
            at += blocks.get(i).length;
        }
        if (!lies.containsKey(offsetTag)) {
            tags.put(offsetTag, numbers(big ? LONG8 : LONG, offsets));
        }
        ByteBuffer file = ByteBuffer.allocate(total).order(order);
        file.put(order == ByteOrder.LITTLE_ENDIAN ? new byte[] {'I', 'I'} : new byte[] {'M', 'M'});
        if (big) {
            file.putShort((short) 43).putShort((short) 8).putShort((short) 0).putLong(start);
            file.putLong(tags.size());
        } else {
            file.putShort((short) 42).putInt(start);
            file.putShort((short) tags.size());
        }
        int values = header;
        for (Map.Entry<Integer, Tag> one : tags.entrySet()) {
            Tag tag = one.getValue();
            file.putShort(one.getKey().shortValue()).putShort((short) tag.type());
            if (big) {
                file.putLong(tag.count());
            } else {
                file.putInt((int) tag.count());
            }
            if (tag.bytes().length <= inside) {
                file.put(tag.bytes()).put(new byte[inside - tag.bytes().length]);
            } else {
                if (big) {
                    file.putLong(values);
                } else {
                    file.putInt(values);
                }
                int here = file.position();
                file.position(values);
                file.put(tag.bytes());
                file.position(here);
                values += tag.bytes().length;
            }
        }
        file.position(after);
        blocks.forEach(file::put);
        return file.array();
    }

    private Tag numbers(int type, long... values) {
        int size = type == SHORT ? 2 : type == LONG ? 4 : 8;
        ByteBuffer buffer = ByteBuffer.allocate(size * values.length).order(order);
        for (long value : values) {
            if (type == SHORT) {
                buffer.putShort((short) value);
            } else if (type == LONG) {
                buffer.putInt((int) value);
            } else {
                buffer.putLong(value);
            }
        }
        return new Tag(type, values.length, buffer.array());
    }

    private Tag doubles(double... values) {
        ByteBuffer buffer = ByteBuffer.allocate(8 * values.length).order(order);
        for (double value : values) {
            buffer.putDouble(value);
        }
        return new Tag(DOUBLE, values.length, buffer.array());
    }

    private static Tag text(String text) {
        byte[] bytes = (text + "\0").getBytes(StandardCharsets.ISO_8859_1);
        return new Tag(2, bytes.length, bytes);
    }

    private Tag keyDirectory() {
        List<Long> shorts = new ArrayList<>(List.of(1L, 1L, 0L, (long) keys.size()));
        keys.forEach((key, value) -> shorts.addAll(List.of((long) key, 0L, 1L, (long) value)));
        return numbers(SHORT, shorts.stream().mapToLong(Long::longValue).toArray());
    }

    private List<byte[]> blocks() {
        List<byte[]> blocks = new ArrayList<>();
        int high = tile > 0 ? tile : stripRows;
        int wide = tile > 0 ? tile : columns;
        for (int top = 0; top < rows; top += high) {
            for (int left = 0; left < columns; left += wide) {
                int here = tile > 0 ? tile : Math.min(stripRows, rows - top);
                blocks.add(blocks.size() == missingBlock ? new byte[0] : packed(padded(block(left, top, wide, here))));
            }
        }
        return blocks;
    }

    private byte[] block(int left, int top, int wide, int high) {
        int size = bits / 8;
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        for (int row = top; row < top + high; row++) {
            long[] line = new long[wide];
            for (int i = 0; i < wide; i++) {
                boolean isInside = left + i < columns && row < rows;
                line[i] = isInside ? stored(samples[row * columns + left + i]) : 0;
            }
            out.writeBytes(predictor == 3 ? floatPredicted(line, size) : plain(line, size));
        }
        return out.toByteArray();
    }

    private long stored(double value) {
        if (format == 3) {
            return bits == 64 ? Double.doubleToRawLongBits(value) : Float.floatToRawIntBits((float) value);
        }
        return Math.round(value);
    }

    private byte[] plain(long[] line, int size) {
        ByteBuffer buffer = ByteBuffer.allocate(size * line.length).order(order);
        for (int i = 0; i < line.length; i++) {
            long value = predictor == 2 && i > 0 ? line[i] - line[i - 1] : line[i];
            switch (size) {
                case 1 -> buffer.put((byte) value);
                case 2 -> buffer.putShort((short) value);
                case 4 -> buffer.putInt((int) value);
                default -> buffer.putLong(value);
            }
        }
        return buffer.array();
    }

    /**
     * Technical note 3: the highest bytes of all numbers first, whatever the order of the file; then differences of
     * bytes.
     */
    private static byte[] floatPredicted(long[] line, int size) {
        byte[] bytes = new byte[size * line.length];
        for (int i = 0; i < line.length; i++) {
            for (int k = 0; k < size; k++) {
                bytes[k * line.length + i] = (byte) (line[i] >> 8 * (size - 1 - k));
            }
        }
        for (int i = bytes.length - 1; i > 0; i--) {
            bytes[i] -= bytes[i - 1];
        }
        return bytes;
    }

    private byte[] padded(byte[] block) {
        return java.util.Arrays.copyOf(block, block.length + padding);
    }

    private byte[] packed(byte[] plain) {
        return switch (compression) {
            case 5 -> lzw(plain);
            case 8, 32946 -> deflated(plain);
            case 32773 -> packBits(plain);
            default -> plain;
        };
    }

    private static byte[] deflated(byte[] plain) {
        Deflater deflater = new Deflater();
        deflater.setInput(plain);
        deflater.finish();
        byte[] buffer = new byte[plain.length + 100];
        int length = deflater.deflate(buffer);
        deflater.end();
        return java.util.Arrays.copyOf(buffer, length);
    }

    private static byte[] packBits(byte[] plain) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        for (int i = 0; i < plain.length; ) {
            int run = 1;
            while (i + run < plain.length && run < 128 && plain[i + run] == plain[i]) {
                run++;
            }
            if (run > 2) {
                out.write(1 - run);
                out.write(plain[i]);
                i += run;
            } else {
                out.write(0);
                out.write(plain[i]);
                i++;
            }
        }
        return out.toByteArray();
    }

    private static byte[] lzw(byte[] plain) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        int held = 0;
        int bits = 0;
        List<Integer> codes = new ArrayList<>();
        for (int i = 0; i < plain.length; i++) {
            if (i % 250 == 0) {
                codes.add(256);
            }
            codes.add(plain[i] & 0xFF);
        }
        codes.add(257);
        for (int code : codes) {
            held = held << 9 | code;
            bits += 9;
            while (bits >= 8) {
                out.write(held >> bits - 8);
                bits -= 8;
                held &= (1 << bits) - 1;
            }
        }
        if (bits > 0) {
            out.write(held << 8 - bits);
        }
        return out.toByteArray();
    }
}
