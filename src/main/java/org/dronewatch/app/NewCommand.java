package org.dronewatch.app;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.create.NewScene;
import org.dronewatch.app.create.NewSiteFiles;
import org.dronewatch.app.option.StoreSwitch;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.World;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Creates a scene of a real place from elevation files and a map. */
@Command(
        name = "new",
        mixinStandardHelpOptions = true,
        description =
                "Creates a scene of a real place: a directory with the given files and a commented scene file that is ready to run,"
                        + " with a sensor of each kind on the highest points, an intruder, and a protected zone.",
        footer = {
            "",
            "Example:",
            "  dronewatch new harbour --at 43.7314,7.4202 --radius 2km --terrain N43E007.hgt --buildings monaco.osm.pbf"
        })
final class NewCommand implements Callable<Integer> {
    private static final double NARROWEST = 200.0;
    private static final double WIDEST = 20_000.0;

    @Parameters(paramLabel = "DIR", description = "Directory to create; an existing one must be empty.")
    private String directory;

    @Option(
            names = "--at",
            required = true,
            paramLabel = "LAT,LON",
            description = "Latitude and longitude of the centre of the site in degrees (WGS 84).")
    private String at;

    @Option(
            names = "--radius",
            paramLabel = "LENGTH",
            description = "How far the site extends from its centre, 200 m to 20 km; 2 km by default.")
    private String radius = "2 km";

    @Option(
            names = "--terrain",
            arity = "1..*",
            paramLabel = "FILE",
            description = "Elevation files: GeoTIFF, SRTM (.hgt, also zipped) or ESRI ASCII grid. They are copied.")
    private List<String> terrain = new ArrayList<>();

    @Option(
            names = "--crs",
            paramLabel = "CODE",
            description = "Coordinate reference system of files that do not state it, such as EPSG:25832.")
    private String crs;

    @Option(
            names = "--buildings",
            paramLabel = "FILE",
            description =
                    "A map with buildings: GeoJSON, CityJSON or OpenStreetMap (.osm, .osm.gz, .osm.pbf). It is copied.")
    private String buildings;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        double[] place = place();
        double metres = metres();
        Path target = target();
        if (terrain.isEmpty() && buildings == null) {
            throw new InputException("needs --terrain, --buildings or both, from which the site is built");
        }
        NewSiteFiles files = new NewSiteFiles(terrain, Optional.ofNullable(buildings), Optional.ofNullable(crs));
        List<Path> copied = files.paths();
        NewScene scene = new NewScene(
                NewScene.nameIn(target),
                place[0],
                place[1],
                metres,
                files.terrainNames(),
                files.terrainCrs(),
                files.isSurface(),
                files.mapName(),
                files.mapCrs());
        if (crs != null && scene.terrainCrs().isEmpty() && scene.mapCrs().isEmpty()) {
            spec.commandLine()
                    .getErr()
                    .println("warning: --crs " + PlainText.value(crs)
                            + " has no effect: all files state their coordinate reference systems");
        }
        Path staging = staging(target);
        try {
            for (Path file : copied) {
                Files.copy(file, staging.resolve(file.getFileName()));
            }
            Path written = staging.resolve(scene.name() + ".yaml");
            Files.writeString(written, scene.site(), StandardCharsets.UTF_8);
            World world = world(written, true);
            Files.writeString(written, scene.whole(world), StandardCharsets.UTF_8);
            world(written, false);
            Files.deleteIfExists(target);
            Files.move(staging, target);
        } catch (InputException e) {
            throw new InputException(files.inOptions(e.getMessage()).replace(staging.toString(), directory), e);
        } catch (IOException e) {
            throw new InputException(asked() + ": cannot be written: " + e.getMessage(), e);
        } finally {
            delete(Objects.requireNonNull(staging.getParent()));
        }
        String file = PlainText.value(Path.of(directory).resolve(scene.name() + ".yaml"));
        spec.commandLine().getOut().println("scene in " + file);
        Notes.of(spec).accept("next: dronewatch view " + file + " or dronewatch run " + file);
        return 0;
    }

    private double[] place() {
        String[] parts = at.strip().split("\\s*[,;]\\s*|\\s+");
        double[] place = new double[2];
        try {
            if (parts.length == 2) {
                place[0] = Double.parseDouble(parts[0].replaceFirst("(?:deg|°)$", ""));
                place[1] = Double.parseDouble(parts[1].replaceFirst("(?:deg|°)$", ""));
            }
        } catch (NumberFormatException e) {
            place[0] = Double.NaN;
        }
        if (parts.length != 2 || !(Math.abs(place[0]) < 90.0) || !(Math.abs(place[1]) <= 180.0)) {
            throw new InputException("--at " + PlainText.value(at)
                    + ": must be latitude and longitude in degrees, -90 to 90 and -180 to 180, as in 43.7314,7.4202");
        }
        return place;
    }

    private double metres() {
        double metres;
        try {
            metres = Quantity.LENGTH.parse(radius);
        } catch (IllegalArgumentException e) {
            throw new InputException("--radius " + PlainText.value(radius) + ": " + e.getMessage(), e);
        }
        if (!(metres >= NARROWEST && metres <= WIDEST)) {
            throw new InputException("--radius " + PlainText.value(radius) + ": must be "
                    + Quantity.LENGTH.inWords(NARROWEST) + " to " + Quantity.LENGTH.inWords(WIDEST));
        }
        return metres;
    }

    private String asked() {
        return "DIR " + PlainText.value(directory);
    }

    private Path target() {
        Path path;
        try {
            path = Path.of(directory).toAbsolutePath().normalize();
        } catch (InvalidPathException e) {
            throw new InputException(asked() + ": not a path: " + e.getReason(), e);
        }
        Path parent = path.getParent();
        if (parent == null || !Files.isDirectory(parent)) {
            throw new InputException(asked() + ": there is no directory " + PlainText.value(String.valueOf(parent)));
        }
        if (Files.isDirectory(path)) {
            try (Stream<Path> content = Files.list(path)) {
                if (content.findAny().isPresent()) {
                    throw new InputException(asked() + ": is not empty: choose a new directory");
                }
            } catch (IOException e) {
                throw new InputException(asked() + ": cannot be read: " + e.getMessage(), e);
            }
        } else if (Files.exists(path)) {
            throw new InputException(asked() + ": is a file");
        }
        return path;
    }

    /** A new directory inside a temporary one: that alone is closed to others, and only its content will be moved. */
    private Path staging(Path target) {
        try {
            return Files.createDirectory(Files.createTempDirectory(target.resolveSibling(""), ".new-")
                    .resolve("site"));
        } catch (IOException e) {
            throw new InputException(asked() + ": no permission to write there", e);
        }
    }

    /** The world of a scene as it is so far; what is read is reported once. */
    private World world(Path file, boolean isFirst) {
        SceneRunner runner = new SceneRunner(new SceneFile(file))
                .store(StoreSwitch.of(spec))
                .notes(note -> {
                    if (isFirst) {
                        Notes.of(spec).accept(note);
                    }
                });
        SceneSettings settings = runner.settings();
        return runner.stage(settings).world();
    }

    private static void delete(Path staging) {
        if (!Files.exists(staging)) {
            return;
        }
        try (Stream<Path> all = Files.walk(staging)) {
            for (Path one : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(one);
            }
        } catch (IOException e) {
            // The user sees it, and why the command failed matters more.
            staging.toFile().deleteOnExit();
        }
    }
}
