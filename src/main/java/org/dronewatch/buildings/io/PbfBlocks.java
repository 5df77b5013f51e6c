package org.dronewatch.buildings.io;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import org.dronewatch.setting.InputException;

/**
 * The blocks of a file in OpenStreetMap's binary format: each has a type, at most 32 MiB, and is deflated separately.
 */
final class PbfBlocks {
    private static final int MOST_HEADER = 64 * 1024;
    private static final int FORMAT_LIMIT = 32 * 1024 * 1024;
    /** What is made of a block takes up to fifteen times its size. */
    private static final int MOST_BLOB =
            (int) Math.min(FORMAT_LIMIT, Runtime.getRuntime().maxMemory() / 32);

    private final String file;
    private final DataInputStream in;
    private String type = "";
    private byte[] blob = {};

    /**
     * The blocks of a stream.
     *
     * @param file its name, for messages
     */
    PbfBlocks(String file, InputStream in) {
        this.file = file;
        this.in = new DataInputStream(in);
    }

    /** Whether a file begins as such files do: the length of a header, and the type of its first block. */
    static boolean isPbf(byte[] start) {
        String text = new String(start, StandardCharsets.ISO_8859_1);
        return start.length > 4 && start[0] == 0 && start[1] == 0 && text.contains("OSMHeader");
    }

    /** Reads the next block; false at the end. */
    boolean next() throws IOException {
        int first = in.read();
        if (first < 0) {
            return false;
        }
        int length = first << 24 | in.readUnsignedByte() << 16 | in.readUnsignedShort();
        if (length <= 0 || length > MOST_HEADER) {
            throw new IOException("a block's header has " + length + " bytes but must have 1 to " + MOST_HEADER);
        }
        type = "";
        long size = -1;
        for (ProtoReader header = new ProtoReader(exactly(in, length)); header.next(); ) {
            switch (header.field()) {
                case 1 -> type = header.text();
                case 3 -> size = header.number();
                default -> header.skip();
            }
        }
        if (size < 0 || size > MOST_BLOB) {
            throw tooLarge(size);
        }
        blob = exactly(in, (int) size);
        return true;
    }

    private static IOException tooLarge(long size) {
        return new IOException("a block has " + size + " bytes but must have at most " + MOST_BLOB
                + (MOST_BLOB < FORMAT_LIMIT ? ", a part of the memory that Java may use (-Xmx)" : ""));
    }

    /** What the block holds. */
    String type() {
        return type;
    }

    private static byte[] exactly(InputStream in, int length) throws IOException {
        byte[] bytes = in.readNBytes(length);
        if (bytes.length < length) {
            throw new EOFException();
        }
        return bytes;
    }

    /** The bytes of the block. */
    byte[] unpacked() throws IOException {
        byte[] deflated = null;
        long size = -1;
        for (ProtoReader reader = new ProtoReader(blob); reader.next(); ) {
            switch (reader.field()) {
                case 1 -> {
                    return reader.copy();
                }
                case 2 -> size = reader.number();
                case 3 -> deflated = reader.copy();
                case 4, 5, 6, 7 ->
                    throw new InputException(file + ": its blocks are compressed with "
                            + List.of("LZMA", "bzip2", "LZ4", "Zstandard").get(reader.field() - 4)
                            + "; 'osmium cat -f pbf' writes a file compressed with zlib");
                default -> reader.skip();
            }
        }
        if (deflated == null || size < 0 || size > MOST_BLOB) {
            throw tooLarge(size);
        }
        return inflated(deflated, (int) size);
    }

    /** No more is unpacked than the block states, and a byte to see whether there is more. */
    private static byte[] inflated(byte[] deflated, int size) throws IOException {
        Inflater inflater = new Inflater();
        try {
            inflater.setInput(deflated);
            byte[] target = new byte[size];
            int at = 0;
            while (at < size) {
                int read = inflater.inflate(target, at, size - at);
                if (read == 0) {
                    throw new EOFException();
                }
                at += read;
            }
            if (inflater.inflate(new byte[1]) > 0) {
                throw new IOException("a block unpacks to more than the " + size + " bytes that it states");
            }
            return target;
        } catch (DataFormatException e) {
            throw new IOException("a block is not in zlib format", e);
        } finally {
            inflater.end();
        }
    }
}
