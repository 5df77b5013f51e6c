package org.dronewatch.docs;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.dronewatch.app.Main;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.viewer.PaintedWindow;

/** All pictures in {@code src/site/images}, and how each is made. */
final class DocPictures {
    static final Path DIRECTORY = Path.of("src", "site", "images");

    /** How the command line that makes a picture names what it writes. */
    private static final String OUT = "OUT";

    private static final String PALACE = "route scenes/palace.yaml --cell 20m --out OUT";
    private static final String PLACEMENT = "place scenes/palace.place.yaml --out OUT";
    private static final String HOUSE = "route DIR/%s --side 900m --cell 20m --heights 10m,20m,40m,80m --out DIR/%s";
    private static final String BIRDS = "route scenes/birds.yaml --cell 20m --out OUT";

    private static final int WIDTH = 1280;
    private static final int HEIGHT = 760;

    /** Those that depend on the code alone. */
    static final List<DocPicture> DRAWN = List.of(
            file(
                    "camera-range",
                    "render camera-range --camera camera --run 2 --time 39 --set sensors.camera.width=1280"
                            + " --set sensors.camera.height=720 --out OUT"),
            file("closed-space", "render closed-space --camera camera --out OUT"),
            file("site-multi-sensor", "render multi-sensor --view orbit --time 12 --out OUT"),
            file("site-acoustic-range", "render acoustic-range --view top --time 60 --out OUT"),
            file("site-camera-range", "render camera-range --view side --time 25 --out OUT"),
            slow(file("terrain-monaco", "render scenes/monaco.yaml --view orbit --bearing 150deg --time 30 --out OUT")),
            file(
                    "coverage-unknown",
                    "coverage scenes/monaco.yaml --side 5000 --height 40 --cells 100 --drone from-the-sea"
                            + " --set sensors.microphone.enabled=false --set sensors.thermal.enabled=false"
                            + " --set sensors.camera.enabled=false --out OUT"),
            file("attack-spotter", "campaign scenes/two-radars.campaign.yaml --case 9 --variant spotter --picture OUT"),
            slow(file(
                    "attack-blighter",
                    "campaign scenes/two-radars.campaign.yaml --case 9 --variant blighter --picture OUT")),
            slow(tutorial("harbour", "render DIR/harbour.yaml --view orbit --time 30 --out OUT")),
            slow(tutorial(
                    "harbour-coverage", "coverage DIR/harbour.yaml --side 1500 --height 30 --cells 40 --out OUT")),
            slow(typed("vendors-spotters", "tutorial-vendors", List.of(decisive("four-spotters")), "case.png")),
            slow(typed("vendors-blighters", "tutorial-vendors", List.of(decisive("two-blighters")), "case.png")),
            slow(typed(
                    "house-routes",
                    "tutorial-route",
                    List.of(HOUSE.formatted("house.yaml", "before")),
                    "before/routes.png")),
            slow(typed(
                    "house-routes-after",
                    "tutorial-route",
                    List.of(
                            "place DIR/house.place.yaml --out DIR/layout",
                            HOUSE.formatted("layout/layout.yaml", "after")),
                    "after/routes.png")),
            slow(map(
                    "coverage-causes",
                    "coverage multi-sensor --side 400m --cell 8m --heights 10m --out OUT",
                    "cause-10.png")),
            slow(map("place-front", PLACEMENT, "front.png")),
            slow(map("place-change", PLACEMENT, "change-30.png")),
            slow(map("route-view", PALACE, "view.png")),
            slow(map("route-plan", BIRDS, "routes.png")),
            slow(map("route-profile", BIRDS, "profile.png")),
            slow(map("route-time-to-go", BIRDS, "time-to-go.png")),
            slow(file(
                    "site-closed-space",
                    "render closed-space --view orbit --rays --max-order 1 --heard-only --out OUT")),
            file("glider", "render scenes/glider.yaml --view side --time 30 --out OUT"),
            slow(file("multi-sensor-coverage", "coverage multi-sensor --side 400 --height 10 --cells 200 --out OUT")),
            slow(file(
                    "colour-noon",
                    "render scenes/daylight.yaml --camera garden --colour --samples 4 --time 11"
                            + " --set sensors.garden.width=800 --set sensors.garden.height=450 --out OUT")),
            slow(file(
                    "colour-dusk",
                    "render scenes/daylight.yaml --camera west --colour --samples 4 --time 3"
                            + " --set sensors.west.width=800 --set sensors.west.height=450 --set sensors.west.fov=16deg"
                            + " --set world.light.sun.azimuth=300deg --set world.light.sun.elevation=-2deg"
                            + " --set world.light.illuminance=20 --out OUT")),
            slow(file(
                    "colour-church",
                    "render closed-space --camera camera --colour --samples 4"
                            + " --set sensors.camera.width=600 --set sensors.camera.height=600 --out OUT")),
            slow(plot("range-over-fov", "run camera-range --out OUT", "range-over-sensors-camera-fov")),
            slow(plot(
                    "closed-space-decay",
                    "run closed-space --observations --set sensors.microphone.propagation=energy-model"
                            + " --set run.duration=0.5 --out OUT",
                    "decay-microphone-quadrotor")),
            new DocPicture("ground-effect", directory -> GroundEffectPlot.draw(), true),
            new DocPicture("radar-crossing", directory -> CrossingPlot.draw(), false),
            new DocPicture("false-alerts", directory -> FalseAlertsPlot.draw(), true),
            new DocPicture("viewer-gallery", directory -> PaintedWindow.gallery(), false),
            slow(window("viewer", "multi-sensor", 25.3)),
            slow(window("cued-camera", "scenes/cued-camera.yaml", 4.0)),
            new DocPicture(
                    "viewer-settings",
                    directory -> PaintedWindow.settings(
                            new SceneRunner(scene("multi-sensor")).set("run.duration", "0.2 s"),
                            "multi-sensor",
                            "north-east-2",
                            Map.of("fov", "20", "rate", "0"),
                            WIDTH,
                            HEIGHT),
                    false),
            new DocPicture(
                    "viewer-beside",
                    directory -> PaintedWindow.comparing(
                            13.4,
                            new SceneRunner(scene("multi-sensor")).set("sensors.north-east-1.fov", "60 deg"),
                            new SceneRunner(scene("multi-sensor")),
                            "multi-sensor",
                            WIDTH,
                            HEIGHT),
                    true),
            new DocPicture(
                    "viewer-tape",
                    directory -> PaintedWindow.measuring(
                            new SceneRunner(scene("multi-sensor")).set("run.duration", "0.2 s"),
                            "multi-sensor",
                            "north-east-2",
                            List.of(0.69, 0.2),
                            WIDTH,
                            HEIGHT),
                    false),
            new DocPicture(
                    "viewer-coverage",
                    directory -> PaintedWindow.coverage(
                            scene("multi-sensor"),
                            List.of("10, 30", "400", "8"),
                            0,
                            Optional.of("microphone"),
                            WIDTH,
                            HEIGHT),
                    true),
            new DocPicture(
                    "viewer-placing",
                    directory -> PaintedWindow.placing(
                            new SceneRunner(scene("multi-sensor")).set("sensors.microphone.enabled", "false"),
                            "multi-sensor",
                            List.of("10", "400", "4"),
                            "south-east-2",
                            List.of(60.0, -45.0, 12.0),
                            WIDTH,
                            HEIGHT),
                    true));

    /** The film of the readme, and the command that makes it. */
    static final String FILM = "monaco.gif";

    private static final String FILMED =
            "render scenes/monaco.yaml --view orbit --bearing 150deg --size 800x450 --scale 0.8 --speed 12 --fps 8 --out OUT";

    /** Those that show how fast the machine was: {@code costs} writes them, as {@code build.png} and so on. */
    static final List<String> MEASURED = List.of(
            "costs-build",
            "costs-triangles",
            "costs-memory",
            "costs-rays",
            "costs-sensors",
            "costs-drones",
            "costs-threads");

    /** The pictures that a command wrote, by their names: several of them may be among those of the pages. */
    private static final Map<String, Map<String, BufferedImage>> WRITTEN = new HashMap<>();

    private DocPictures() {}

    /** Draws a picture; files on the way there may go into a directory. */
    interface Drawing {
        BufferedImage draw(Path directory) throws Exception;
    }

    /**
     * A picture.
     *
     * @param name of its file, without {@code .png}
     * @param isSlow whether drawing it takes seconds
     */
    record DocPicture(String name, Drawing drawing, boolean isSlow) {
        Path file() {
            return DocPictures.file(name);
        }

        @Override
        public String toString() {
            return name;
        }
    }

    /** The file of a picture. */
    static Path file(String name) {
        return DIRECTORY.resolve(name + ".png");
    }

    private static DocPicture slow(DocPicture picture) {
        return new DocPicture(picture.name(), picture.drawing(), true);
    }

    /** A picture that a command writes. */
    private static DocPicture file(String name, String command) {
        return new DocPicture(
                name,
                directory -> {
                    Path written = directory.resolve(name + ".png");
                    run(command, written);
                    return read(written);
                },
                false);
    }

    /** A picture of the scene that the tutorial makes. */
    private static DocPicture tutorial(String name, String command) {
        return new DocPicture(
                name,
                directory -> {
                    Path scene = directory.resolve("harbour");
                    run(
                            "new OUT --at 43.7314,7.4202 --radius 1500m --terrain sites/monaco-srtm.asc --crs EPSG:4326"
                                    + " --buildings sites/monaco.osm.gz",
                            scene);
                    Path written = directory.resolve(name + ".png");
                    run(command.replace("DIR", scene.toString()), written);
                    return read(written);
                },
                false);
    }

    /** The command that draws a case of a tutorial, flown with one of its variants. */
    private static String decisive(String variant) {
        return "campaign DIR/vendors.campaign.yaml --case 22 --picture DIR/case.png --variant " + variant;
    }

    /** A picture among what commands write that are typed where the files of a tutorial are. */
    private static DocPicture typed(String name, String page, List<String> commands, String picture) {
        return new DocPicture(
                name,
                directory -> {
                    new TutorialPage(page).writeFiles(directory);
                    for (String command : commands) {
                        run(command.replace("DIR", directory.toString()), directory);
                    }
                    return read(directory.resolve(picture));
                },
                false);
    }

    /** A plot among what a run writes. */
    private static DocPicture plot(String name, String command, String plot) {
        return new DocPicture(
                name,
                directory -> {
                    run(command, directory);
                    return read(directory.resolve("plots").resolve(plot + ".png"));
                },
                false);
    }

    /** A picture among those that {@code coverage}, {@code route} or {@code place} writes. */
    private static DocPicture map(String name, String command, String map) {
        return new DocPicture(
                name,
                directory -> {
                    if (!WRITTEN.containsKey(command)) {
                        Path written = directory.resolve(name);
                        run(command, written);
                        WRITTEN.put(command, pictures(written));
                    }
                    return Optional.ofNullable(WRITTEN.get(command).get(map))
                            .orElseThrow(() -> new IllegalStateException(command + " does not write " + map));
                },
                false);
    }

    private static Map<String, BufferedImage> pictures(Path written) throws IOException {
        Map<String, BufferedImage> pictures = new HashMap<>();
        try (Stream<Path> files = Files.list(written)) {
            for (Path file :
                    files.filter(one -> one.toString().endsWith(".png")).toList()) {
                pictures.put(file.getFileName().toString(), read(file));
            }
        }
        return pictures;
    }

    /** The window below its menus, at a time of the run, s. */
    private static DocPicture window(String name, String scene, double time) {
        return new DocPicture(name, directory -> PaintedWindow.at(time, scene(scene), WIDTH, HEIGHT), false);
    }

    private static Scene scene(String name) {
        return SceneFile.isFileName(name)
                ? new SceneFile(Path.of(name))
                : PackagedScene.find(name).orElseThrow().factory().get();
    }

    /** Measures, which takes minutes, and writes all plots of it. */
    static void measure(Path directory) throws IOException {
        run("costs --out OUT", directory);
        for (String name : MEASURED) {
            Files.write(file(name), Files.readAllBytes(directory.resolve(name.substring("costs-".length()) + ".png")));
        }
    }

    /** Makes the film anew. */
    static Path film(Path directory) {
        Path written = directory.resolve(FILM);
        run(FILMED, written);
        return written;
    }

    static BufferedImage read(Path file) throws IOException {
        return ImageIO.read(file.toFile());
    }

    /** Runs a command line in which {@code OUT} stands for a path. */
    static void run(String command, Path out) {
        List<String> arguments = new ArrayList<>(List.of(command.split(" ")));
        arguments.replaceAll(word -> word.equals(OUT) ? out.toString() : word);
        StringWriter said = new StringWriter();
        PrintWriter both = new PrintWriter(said);
        int code = Main.execute(both, both, arguments.toArray(String[]::new));
        if (code != 0) {
            throw new IllegalStateException(command + " ended with " + code + ": " + said);
        }
    }
}
