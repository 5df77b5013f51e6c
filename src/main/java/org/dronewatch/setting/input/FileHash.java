package org.dronewatch.setting.input;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/**
 * The name of a file with the hash of its bytes when it was read.
 *
 * @param file name of the file, without directories that differ from machine to machine
 * @param sha256 SHA-256 of its bytes, 64 hexadecimal digits in lower case
 */
public record FileHash(String file, String sha256) {
    private static final int BUFFER_BYTES = 1 << 16;

    /**
     * Reads a stream to its end.
     *
     * @throws IOException when it cannot be read
     */
    public static FileHash of(String file, InputStream bytes) throws IOException {
        MessageDigest digest = newDigest();
        byte[] buffer = new byte[BUFFER_BYTES];
        for (int read = bytes.read(buffer); read >= 0; read = bytes.read(buffer)) {
            digest.update(buffer, 0, read);
        }
        return new FileHash(file, HexFormat.of().formatHex(digest.digest()));
    }

    /** The hash of a text in UTF-8. */
    public static String ofText(String text) {
        return HexFormat.of().formatHex(newDigest().digest(text.getBytes(StandardCharsets.UTF_8)));
    }

    private static MessageDigest newDigest() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java platform has SHA-256", e);
        }
    }
}
