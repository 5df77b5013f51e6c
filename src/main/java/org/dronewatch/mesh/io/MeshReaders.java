package org.dronewatch.mesh.io;

import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.dronewatch.setting.FoundKind;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.KindRegistry;
import org.dronewatch.setting.PlainText;

/** The readers of model files on the class path, by file extension. Immutable. */
public final class MeshReaders {
    private static final String OBJ = "obj";

    private static MeshReaders found;

    private final Map<String, MeshReader> byExtension = new TreeMap<>();

    /**
     * A set of readers.
     *
     * @throws InputException if two read the same extension, in one line with both locations, or one is invalid
     */
    MeshReaders(List<MeshReader> readers) {
        for (MeshReader reader : readers) {
            for (String extension : extensions(reader)) {
                if (!extension.matches("[a-z0-9]{1,16}")) {
                    throw new InputException("mesh reader from " + FoundKind.placeOf(reader.getClass())
                            + ": extension '" + extension + "' must be 1 to 16 lower-case letters and digits");
                }
                MeshReader former = byExtension.putIfAbsent(extension, reader);
                if (former != null) {
                    throw new InputException("files '." + extension + "' are read by "
                            + FoundKind.placeOf(former.getClass()) + " and by " + FoundKind.placeOf(reader.getClass())
                            + ": remove one of them from the class path");
                }
            }
        }
    }

    /** What a reader of another jar reads; its code may fail. */
    private static Set<String> extensions(MeshReader reader) {
        try {
            return Set.copyOf(reader.extensions());
        } catch (RuntimeException | LinkageError e) {
            throw new InputException(
                    "mesh reader " + reader.getClass().getName() + " from " + FoundKind.placeOf(reader.getClass())
                            + " fails: " + PlainText.value(e.toString()),
                    e);
        }
    }

    /**
     * The readers on this program's class path; the search runs once.
     *
     * @throws InputException when one cannot be loaded or is invalid, or two read the same extension
     */
    public static synchronized MeshReaders found() {
        if (found == null) {
            found = new MeshReaders(KindRegistry.providers(MeshReader.class));
        }
        return found;
    }

    /** All readers by extension, in alphabetical order. */
    public Map<String, MeshReader> byExtension() {
        return Collections.unmodifiableMap(byExtension);
    }

    /** The reader of a file of this name; a name with no known extension is taken for that of an OBJ file. */
    MeshReader of(String fileName) {
        return byExtension.getOrDefault(extension(fileName), byExtension.get(OBJ));
    }

    /** Whether there is a reader for files of this name. */
    boolean knows(String fileName) {
        return byExtension.containsKey(extension(fileName));
    }

    private static String extension(String fileName) {
        return fileName.substring(fileName.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
    }
}
