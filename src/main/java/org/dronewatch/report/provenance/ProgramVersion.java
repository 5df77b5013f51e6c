package org.dronewatch.report.provenance;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Properties;

/** The version of this program, which the build writes to a resource. */
public final class ProgramVersion {
    /** The name of the program. */
    public static final String PROGRAM = "dronewatch";

    /** The version of a build that does not fill in the resource, such as that of an IDE. */
    static final String UNKNOWN = "development";

    private static final String RESOURCE = "version.properties";

    private ProgramVersion() {}

    /** The version, such as {@code 1.2.0}; {@code development} if the build has not filled it in. */
    public static String text() {
        Properties properties = new Properties();
        try (InputStream resource = ProgramVersion.class.getResourceAsStream(RESOURCE)) {
            if (resource != null) {
                properties.load(resource);
            }
        } catch (IOException e) {
            throw new UncheckedIOException("resource " + RESOURCE + " cannot be read", e);
        }
        return filled(properties.getProperty("version", ""));
    }

    /** A placeholder that the build did not replace is not a version. */
    static String filled(String version) {
        return version.isBlank() || version.contains("${") || version.contains("@") ? UNKNOWN : version.strip();
    }
}
