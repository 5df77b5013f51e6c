package org.dronewatch.setting.input;

import java.io.IOException;
import java.io.InputStream;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** Files of real places that are included in the library, by names such as {@code packaged:monaco-srtm.asc}. */
public final class PackagedSite {
    /** The prefix of the names of packaged files. */
    public static final String PREFIX = "packaged:";

    private static final String RESOURCES = "/sites/";

    private PackagedSite() {}

    /** Whether a name refers to a packaged file, not to a file on disk. */
    public static boolean isNamed(String name) {
        return name.startsWith(PREFIX);
    }

    /** The name without its prefix. */
    public static String plain(String name) {
        return isNamed(name) ? name.substring(PREFIX.length()) : name;
    }

    /**
     * The bytes of a file.
     *
     * @throws InputException when there is no such file
     */
    public static byte[] bytes(String name) {
        String plain = plain(name);
        boolean isPlain = plain.matches("[\\w.-]+") && !plain.contains("..");
        try (InputStream in = isPlain ? PackagedSite.class.getResourceAsStream(RESOURCES + plain) : null) {
            if (in == null) {
                throw new InputException("no packaged file '" + PlainText.value(plain) + "'");
            }
            return in.readAllBytes();
        } catch (IOException e) {
            throw new InputException("packaged file '" + plain + "' cannot be read: " + e.getMessage(), e);
        }
    }
}
