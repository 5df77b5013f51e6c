package org.dronewatch.mesh.io;

import de.javagl.obj.FloatTuple;
import de.javagl.obj.Mtl;
import de.javagl.obj.MtlReader;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CancellationException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.parallel.Interrupts;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.FileHash;

/**
 * The MTL files of a model: which materials they define, and their colours. A library that cannot be read is a warning:
 * its materials are then names without a colour.
 */
final class MaterialLibraries {
    private static final int MAX_NAMES = 10;

    /** What Java could not read as a number, in the message of its exception. */
    private static final Pattern QUOTED = Pattern.compile("\"(.*)\"");

    private final ModelFile model;
    private final Set<String> defined = new HashSet<>();
    private final Map<String, Integer> colours = new HashMap<>();
    private final List<FileHash> files = new ArrayList<>();
    private final List<String> warnings = new ArrayList<>();

    MaterialLibraries(ModelFile model) {
        this.model = model;
    }

    /**
     * Reads libraries up to the first that cannot be found.
     *
     * @param names as the model names them
     * @param used the names of the materials that the model uses
     * @throws CancellationException when the thread is interrupted while a library is read
     */
    void read(Collection<String> names, Collection<String> used) {
        for (String name : names) {
            ModelFile library;
            try {
                library = model.beside(name);
            } catch (InputException e) {
                warnings.add(model.name() + ": material library '" + name + "' " + e.getMessage()
                        + "; its materials have no colours");
                return;
            }
            read(library);
        }
        if (!names.isEmpty()) {
            warnOfUndefined(used);
        }
    }

    private void warnOfUndefined(Collection<String> used) {
        Set<String> undefined = new TreeSet<>(used);
        undefined.removeAll(defined);
        undefined.remove(ObjMeshCollector.NO_MATERIAL);
        if (undefined.isEmpty()) {
            return;
        }
        int more = undefined.size() - MAX_NAMES;
        List<String> first = undefined.stream().limit(MAX_NAMES).toList();
        warnings.add(model.name() + ": materials that are used but defined in no material library: "
                + String.join(", ", first) + (more > 0 ? " and " + more + " more" : ""));
    }

    private void read(ModelFile library) {
        try (ObjLines lines = new ObjLines(library.text())) {
            files.add(library.hash());
            try {
                for (Mtl material : MtlReader.read(lines)) {
                    defined.add(material.getName());
                    if (material.getKd() != null) {
                        colours.put(material.getName(), colour(material.getKd()));
                    }
                }
            } catch (CancellationException | ClosedByInterruptException e) {
                throw e;
            } catch (IOException | RuntimeException e) {
                // The parser throws whatever its string handling happens to throw on a line it did not expect.
                warnings.add(lines.at(library.name()) + "not a material library: " + reason(e));
            }
        } catch (IOException e) {
            if (Interrupts.isIn(e)) {
                throw new CancellationException("interrupted while a material library was read");
            }
            warnings.add(library.name() + ": cannot be read: " + e.getMessage());
        }
    }

    /** The part of the message that helps a reader: the parser wraps Java's own message about a number. */
    private static String reason(Exception problem) {
        Throwable cause = problem.getCause() == null ? problem : problem.getCause();
        String message = cause.getMessage() == null ? "is not a statement of an MTL file" : cause.getMessage();
        Matcher quoted = QUOTED.matcher(message);
        return cause instanceof NumberFormatException && quoted.find()
                ? "'" + quoted.group(1) + "' is not a number"
                : message;
    }

    /** A diffuse colour of an MTL file, each part between 0 and 1, as it is shown on a screen. */
    private static int colour(FloatTuple diffuse) {
        int rgb = 0;
        for (int channel = 0; channel < 3; channel++) {
            // Not a number becomes 0, as a cast does.
            rgb = rgb << 8 | (int) (255.0f * Math.max(0.0f, Math.min(1.0f, diffuse.get(channel))) + 0.5f);
        }
        return rgb;
    }

    /** The colours by material name; those without one are left out. */
    Map<String, Integer> colours() {
        return colours;
    }

    /** Which bytes were read, in the order of the libraries. */
    List<FileHash> files() {
        return files;
    }

    List<String> warnings() {
        return warnings;
    }
}
