package org.dronewatch.scene;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.dronewatch.geo.features.Features;
import org.dronewatch.setting.input.BoundedFile;
import org.dronewatch.setting.input.LinkOut;

/** The maps whose features a scene file refers to, each read once. */
final class FeatureFiles implements Function<Optional<String>, Features> {
    private static final List<String> ENDINGS = List.of(".geojson", ".kml");

    private final Path scene;
    private final Map<Path, Features> known = new LinkedHashMap<>();

    /**
     * No maps yet.
     *
     * @param scene the scene file
     */
    FeatureFiles(Path scene) {
        this.scene = scene;
    }

    /**
     * The features of a map.
     *
     * @param file its name, relative to the directory of the scene file; if empty, the map that has the scene file's
     *     name
     * @throws IllegalArgumentException when there is none with the scene file's name
     * @throws org.dronewatch.setting.InputException when it cannot be read, or is invalid
     */
    @Override
    public Features apply(Optional<String> file) {
        Path path = file.map(scene::resolveSibling).orElseGet(this::beside);
        Features features = known.get(path);
        if (features == null) {
            Path directory = scene.toAbsolutePath().resolveSibling("");
            LinkOut.refuse(directory, path, "file");
            String shown = file.orElseGet(() -> String.valueOf(path.getFileName()));
            features = Features.read(shown, BoundedFile.read(path, Features.LARGEST));
            known.put(path, features);
        }
        return features;
    }

    private Path beside() {
        String name = String.valueOf(scene.getFileName()).replaceFirst("\\.[A-Za-z]+$", "");
        List<Path> found = new ArrayList<>();
        for (String ending : ENDINGS) {
            Path path = scene.resolveSibling(name + ending);
            if (Files.exists(path)) {
                found.add(path);
            }
        }
        if (found.size() != 1) {
            throw new IllegalArgumentException((found.isEmpty() ? "neither " : "both ") + name + ENDINGS.get(0)
                    + (found.isEmpty() ? " nor " : " and ") + name + ENDINGS.get(1)
                    + (found.isEmpty() ? " is" : " are") + " next to the scene file: give 'file'");
        }
        return found.get(0);
    }

    /** The maps that were read. */
    List<Path> read() {
        return List.copyOf(known.keySet());
    }
}
