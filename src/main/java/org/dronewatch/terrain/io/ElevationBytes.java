package org.dronewatch.terrain.io;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;

/** The bytes of a file of elevations, on disk or in memory. */
final class ElevationBytes {
    private final String name;
    private final Path path;
    private final byte[] bytes;
    private final long size;

    private ElevationBytes(String name, Path path, byte[] bytes, long size) {
        this.name = name;
        this.path = path;
        this.bytes = bytes;
        this.size = size;
    }

    /** A file on disk, which stays closed between calls. */
    static ElevationBytes of(String name, Path path) throws IOException {
        return new ElevationBytes(name, path, new byte[0], Files.size(path));
    }

    /** Bytes in memory, which are kept, not copied. */
    static ElevationBytes of(String name, byte[] bytes) {
        return new ElevationBytes(name, null, bytes, bytes.length);
    }

    String name() {
        return name;
    }

    /** The last part of the name, in lower case. */
    String shortName() {
        return shortName(name);
    }

    /** The last part of a name, in lower case. */
    static String shortName(String name) {
        String slashes = name.replace('\\', '/');
        return slashes.substring(slashes.lastIndexOf('/') + 1).toLowerCase(Locale.ROOT);
    }

    long size() {
        return size;
    }

    InputStream open() throws IOException {
        return new BufferedInputStream(path == null ? new ByteArrayInputStream(bytes) : Files.newInputStream(path));
    }

    /**
     * Some bytes.
     *
     * @throws EOFException when the file is too short
     */
    byte[] read(long at, int length) throws IOException {
        if (at < 0 || at > size - length) {
            throw new EOFException();
        }
        if (path == null) {
            return Arrays.copyOfRange(bytes, (int) at, (int) at + length);
        }
        ByteBuffer buffer = ByteBuffer.allocate(length);
        try (FileChannel channel = FileChannel.open(path)) {
            while (buffer.hasRemaining()) {
                if (channel.read(buffer, at + buffer.position()) < 0) {
                    throw new EOFException();
                }
            }
        }
        return buffer.array();
    }
}
