package org.dronewatch.app.create;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronewatch.buildings.io.MapFiles;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.RegularFile;
import org.dronewatch.terrain.io.ElevationFile;
import org.dronewatch.terrain.io.ElevationFiles;

/**
 * The files of a new scene, as they were named on the command line.
 *
 * @param terrain elevation files
 * @param map map with buildings; empty if none was named
 * @param crs coordinate reference system of the files that do not state one; empty if none was given
 */
public record NewSiteFiles(List<String> terrain, Optional<String> map, Optional<String> crs) {
    private static final String TERRAIN = "--terrain";
    private static final String MAP = "--buildings";

    /** A message about a file of the scene that is being written. */
    private static final Pattern IN_SCENE = Pattern.compile(".*?:\\d+:\\d+: world\\.(terrain|buildings): (.*)");

    /** All files to copy; they go into one directory, so their names must differ. */
    public List<Path> paths() {
        List<Path> files = new ArrayList<>();
        Set<String> names = new HashSet<>();
        terrain.forEach(file -> add(TERRAIN, file, files, names));
        map.ifPresent(file -> add(MAP, file, files, names));
        return files;
    }

    private static void add(String option, String file, List<Path> files, Set<String> names) {
        String given = option + " " + PlainText.value(file) + ": ";
        Path path;
        try {
            path = Path.of(file);
        } catch (InvalidPathException e) {
            throw new InputException(given + "not a path: " + e.getReason(), e);
        }
        String obstacle = RegularFile.obstacle(path);
        if (!obstacle.isEmpty()) {
            throw new InputException(given + obstacle);
        }
        if (!names.add(name(file).toLowerCase(Locale.ROOT))) {
            throw new InputException(given + "another file has the same name; they are copied into one directory");
        }
        files.add(path);
    }

    private static String name(String file) {
        return String.valueOf(Path.of(file).getFileName());
    }

    public List<String> terrainNames() {
        return terrain.stream().map(NewSiteFiles::name).toList();
    }

    public Optional<String> mapName() {
        return map.map(NewSiteFiles::name);
    }

    /** The coordinate reference system to state for the elevations; empty if all files state their own. */
    public Optional<String> terrainCrs() {
        return crs(TERRAIN, terrain.stream(), file -> open(file).needsCrs());
    }

    /** The coordinate reference system to state for the map; empty if it states its own. */
    public Optional<String> mapCrs() {
        return crs(MAP, map.stream(), NewSiteFiles::needsCrs);
    }

    private Optional<String> crs(String option, Stream<String> files, Predicate<String> needsCrs) {
        crs.ifPresent(code -> {
            try {
                CoordinateReferenceSystem.of(code);
            } catch (InputException e) {
                throw new InputException("--crs " + PlainText.value(code) + ": " + e.getMessage(), e);
            }
        });
        Optional<String> without = files.filter(needsCrs).findFirst();
        if (crs.isEmpty() && without.isPresent()) {
            throw new InputException(option + " " + PlainText.value(without.get())
                    + ": does not state a known coordinate reference system: add --crs, as in --crs EPSG:25832, or --crs EPSG:4326"
                    + " for longitude and latitude");
        }
        return without.flatMap(file -> crs);
    }

    /** Whether the elevations include roofs and treetops. */
    public boolean isSurface() {
        return terrain.stream().anyMatch(file -> open(file).isSurfaceModel());
    }

    private static ElevationFile open(String file) {
        try {
            return new ElevationFiles(Path.of("")).open(file);
        } catch (InputException e) {
            throw new InputException(TERRAIN + " " + e.getMessage(), e);
        }
    }

    private static boolean needsCrs(String file) {
        try {
            return new MapFiles(Path.of("")).needsCrs(file);
        } catch (InputException e) {
            throw new InputException(MAP + " " + e.getMessage(), e);
        }
    }

    /**
     * Rewrites a message so that it refers to the command-line option that names the file, not to a line of the
     * generated scene, which the user has not seen. Other messages are returned unchanged.
     */
    public String inOptions(String message) {
        Matcher located = IN_SCENE.matcher(message);
        if (!located.matches()) {
            return message;
        }
        boolean isTerrain = located.group(1).equals("terrain");
        String option = isTerrain ? TERRAIN : MAP;
        String problem = located.group(2);
        return (isTerrain ? terrain.stream() : map.stream())
                .filter(file -> problem.startsWith(name(file) + ":"))
                .findFirst()
                .map(file -> option + " " + PlainText.value(file)
                        + problem.substring(name(file).length()))
                .orElse(option + ": " + problem);
    }
}
