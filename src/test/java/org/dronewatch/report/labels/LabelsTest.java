package org.dronewatch.report.labels;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.app.Main;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.Stage;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DepthImage;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.DronePixels;
import org.dronewatch.sensor.optics.PictureSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The labels are what the sensors hit: pixel by pixel, and as many as the table of observations says. */
class LabelsTest {
    @TempDir
    private Path directory;

    private String run(int code, String... arguments) {
        StringWriter out = new StringWriter();
        PrintWriter both = new PrintWriter(out, true);
        assertThat(Main.execute(both, both, arguments)).as(out.toString()).isEqualTo(code);
        return out.toString();
    }

    private JsonNode coco(String... arguments) throws IOException {
        run(
                0,
                Stream.concat(
                                Stream.of(arguments),
                                Stream.of(
                                        "--observations",
                                        "--out",
                                        directory.resolve("r").toString()))
                        .toArray(String[]::new));
        return JsonMapper.builder().build().readTree(Files.readString(directory.resolve("r/coco.json")));
    }

    /** The value that each camera observed of each drone in each look with at least one pixel. */
    private Map<String, Integer> observed() throws IOException {
        List<String> lines = Files.readAllLines(directory.resolve("r/observations.csv"));
        List<String> head = List.of(lines.get(0).split(","));
        Map<String, Integer> values = new HashMap<>();
        for (String line : lines.subList(1, lines.size())) {
            String[] cells = line.split(",", -1);
            if (cells[head.indexOf("kind")].equals("camera") && !cells[head.indexOf("value")].equals("0")) {
                values.put(
                        String.join(
                                " ",
                                cells[head.indexOf("run")],
                                cells[head.indexOf("sensor")],
                                cells[head.indexOf("time_s")],
                                cells[head.indexOf("drone")],
                                cells[head.indexOf("range_m")]),
                        Integer.parseInt(cells[head.indexOf("value")]));
            }
        }
        return values;
    }

    private static Map<String, Integer> areas(JsonNode coco) {
        Map<String, Integer> areas = new HashMap<>();
        for (JsonNode annotation : coco.get("annotations")) {
            JsonNode image = coco.get("images").get(annotation.get("image_id").asInt() - 1);
            areas.put(
                    String.join(
                            " ",
                            annotation.get("run").asString(),
                            image.get("camera").asString(),
                            annotation.get("time_s").asString(),
                            annotation.get("drone").asString(),
                            annotation.get("range_m").asString()),
                    annotation.get("area").asInt());
        }
        return areas;
    }

    /** Decodes run lengths as COCO defines them. */
    private static boolean[][] decoded(JsonNode segmentation) {
        int height = segmentation.get("size").get(0).asInt();
        int width = segmentation.get("size").get(1).asInt();
        boolean[][] rows = new boolean[height][width];
        int at = 0;
        boolean value = false;
        for (JsonNode count : segmentation.get("counts")) {
            for (int i = 0; i < count.asInt(); i++, at++) {
                rows[at % height][at / height] = value;
            }
            value = !value;
        }
        assertThat(at).isEqualTo(width * height);
        return rows;
    }

    private static int[] box(boolean[][] mask) {
        int[] box = {Integer.MAX_VALUE, Integer.MAX_VALUE, -1, -1};
        for (int row = 0; row < mask.length; row++) {
            for (int column = 0; column < mask[row].length; column++) {
                if (mask[row][column]) {
                    box[0] = Math.min(box[0], column);
                    box[1] = Math.min(box[1], row);
                    box[2] = Math.max(box[2], column);
                    box[3] = Math.max(box[3], row);
                }
            }
        }
        return new int[] {box[0], box[1], box[2] - box[0] + 1, box[3] - box[1] + 1};
    }

    private void assertNumbered(JsonNode coco) {
        for (int i = 0; i < coco.get("images").size(); i++) {
            JsonNode image = coco.get("images").get(i);
            assertThat(image.get("id").asInt()).isEqualTo(i + 1);
            Path file = directory.resolve("r").resolve(image.get("file_name").asString());
            assertThat(file).exists();
        }
        int before = 0;
        for (int i = 0; i < coco.get("annotations").size(); i++) {
            JsonNode annotation = coco.get("annotations").get(i);
            assertThat(annotation.get("id").asInt()).isEqualTo(i + 1);
            assertThat(annotation.get("iscrowd").asInt()).isZero();
            assertThat(annotation.get("category_id").asInt()).isEqualTo(1);
            assertThat(annotation.get("image_id").asInt()).isGreaterThanOrEqualTo(before);
            before = annotation.get("image_id").asInt();
        }
    }

    /** Small pictures, since it is the masks that count. */
    private static final String[] SMALL = {
        "--set", "sensors.north-east-1.width=320", "--set", "sensors.north-east-1.height=180",
        "--set", "sensors.north-west-3.width=320", "--set", "sensors.north-west-3.height=180",
        "--set", "sensors.south-east-2.width=320", "--set", "sensors.south-east-2.height=180"
    };

    /** Sensors of multi-sensor of which no pictures are taken here. */
    private static final List<String> UNLABELLED = List.of(
            "north-east-2",
            "north-east-3",
            "south-east-1",
            "south-east-3",
            "south-west-1",
            "south-west-2",
            "south-west-3",
            "north-west-1",
            "north-west-2",
            "microphone");

    /**
     * The packaged scene with three of its cameras. The reference is the full image of distances, traced apart from the
     * masks: a pixel shows the drone where it does so there. In the long form the pictures are as large as the scene's,
     * and the other sensors look, too.
     */
    @Thorough
    @Test
    void masksOfMultiSensorAreTheHitsOfItsCameras() throws IOException {
        List<String> arguments = new ArrayList<>(List.of(
                "run",
                "multi-sensor",
                "--labels",
                "south-east-2",
                "--labels",
                "north-west-3",
                "--labels",
                "north-east-1",
                "--set",
                "sensors.north-west-3.rate=2",
                "--set",
                "sensors.north-east-1.rate=2",
                "--set",
                "sensors.south-east-2.rate=1"));
        arguments.addAll(List.of("--set", "run.duration=31", "--samples", "1"));
        if (!LongForm.IS_ON) {
            arguments.addAll(List.of(SMALL));
            for (String other : UNLABELLED) {
                arguments.addAll(List.of("--set", "sensors." + other + ".enabled=false"));
            }
        }
        JsonNode coco = coco(arguments.toArray(String[]::new));
        assertNumbered(coco);
        Map<String, Integer> values = observed();
        values.keySet().removeIf(key -> Stream.of(" south-east-2 ", " north-west-3 ", " north-east-1 ")
                .noneMatch(key::contains));
        assertThat(areas(coco)).isEqualTo(values).hasSizeGreaterThan(20);

        // In the order of the scene, and a picture for each look, the empty ones of the camera that sees nothing among
        // them.
        assertThat(cameras(coco)).containsExactly("north-east-1", "south-east-2", "north-west-3");
        assertThat(coco.get("images")).hasSize(63 + 32 + 63);
        BufferedImage empty = ImageIO.read(
                directory.resolve("r/labels/south-east-2/000031.png").toFile());
        assertThat(empty.getWidth() * empty.getHeight()).isEqualTo(LongForm.count(320 * 180, 1920 * 1080));

        SceneRunner runner = new SceneRunner(
                PackagedScene.find("multi-sensor").orElseThrow().factory().get());
        for (int i = 2; i < arguments.size() - 1; i++) {
            if (arguments.get(i).equals("--set")) {
                String[] parts = arguments.get(i + 1).split("=");
                runner.set(parts[0], parts[1]);
            }
        }
        Stage stage = runner.stage(runner.settings());
        for (JsonNode annotation : coco.get("annotations")) {
            JsonNode image = coco.get("images").get(annotation.get("image_id").asInt() - 1);
            SensorSettings<?> sensor =
                    runner.settings().sensors().get(image.get("camera").asString());
            DepthImage depth = new DronePicture(
                            new CameraObject(sensor.as(PictureSettings.class).orElseThrow()))
                    .depthImage(stage.world(), stage.dronesAt(image.get("look").asInt() / sensor.rate()));
            boolean[][] mask = decoded(annotation.get("segmentation"));
            assertThat(mask).hasDimensions(empty.getHeight(), empty.getWidth());
            for (int row = 0; row < mask.length; row++) {
                for (int column = 0; column < mask[row].length; column++) {
                    assertThat(mask[row][column]).isEqualTo(depth.isHit(column, row));
                }
            }
            assertThat(Stream.of(0, 1, 2, 3)
                            .mapToInt(k -> annotation.get("bbox").get(k).asInt()))
                    .containsExactly(Arrays.stream(box(mask)).boxed().toArray(Integer[]::new));
        }
    }

    private static List<String> cameras(JsonNode coco) {
        List<String> cameras = new ArrayList<>();
        coco.get("images").forEach(image -> {
            if (cameras.isEmpty()
                    || !cameras.get(cameras.size() - 1)
                            .equals(image.get("camera").asString())) {
                cameras.add(image.get("camera").asString());
            }
        });
        return cameras;
    }

    /** A camera on a positioner with a zoom, in a sweep: labels follow where it points at each look. */
    @Thorough
    @Test
    void labelsFollowAPositionerAndNameRuns() throws IOException {
        Path scene = directory.resolve("counted.yaml");
        Files.writeString(
                scene,
                Files.readString(Path.of("scenes/cued-camera.yaml"))
                        .replaceAll("(?m)^( +detection: ).*\n", "$1{kind: pixel-threshold}\n")
                        .replace("duration: 55 s", "duration: 12 s")
                        .replace(
                                "sensors:\n",
                                "sweep: {kind: values, parameter: drones.intruder.speed, values: [12, 15]}\nsensors:\n")
                        .replace(
                                "    use: piranha-46-hr\n",
                                "    use: piranha-46-hr\n    rate: 2 Hz\n    width: 320 px\n    height: 200 px\n"));
        JsonNode coco = coco("run", scene.toString(), "--labels", "cued", "--samples", "1");
        assertNumbered(coco);
        Map<String, Integer> values = observed();
        values.keySet().removeIf(key -> !key.contains(" cued "));
        assertThat(areas(coco)).isEqualTo(values).isNotEmpty();
        assertThat(coco.get("images").get(25).get("file_name").asString()).isEqualTo("labels/run-1/cued/000000.png");
        assertThat(coco.get("images")).hasSize(50);
    }

    /** Views of a drone from random places, so near that it reaches all edges of the image: seed 1. */
    @Test
    void runLengthsDecodeToTheHits() throws IOException {
        List<DronePixels> seen = new ArrayList<>();
        Scene scene = new SceneFile(Path.of("scenes/daylight.yaml"));
        SceneRunner runner = new SceneRunner(scene)
                .set("sensors.west.rate", "1")
                .set("run.duration", "1")
                .listener(new SceneListener() {
                    private Stage stage;

                    @Override
                    public void runStarted(RunInfo run, Stage its) {
                        stage = its;
                    }

                    @Override
                    public void observed(Frame frame) {
                        Random random = new Random(1);
                        for (int i = 0; i < 200; i++) {
                            CameraObject camera = new CameraObject(
                                    frame.drones()
                                            .get(0)
                                            .origin()
                                            .plus(new Position(
                                                    random.nextDouble() - 0.5, -1.2, random.nextDouble() - 0.5)),
                                    new Position(0.4 * random.nextDouble() - 0.2, 1, 0.1),
                                    17 + random.nextInt(9),
                                    13 + random.nextInt(9),
                                    10 + 80 * random.nextDouble());
                            DronePixels hits = new DronePicture(camera)
                                    .pixels(stage.world(), frame.drones())
                                    .get(0);
                            if (hits.count() > 0) {
                                seen.add(hits);
                                assertSame(hits, camera.width(), camera.height());
                            }
                        }
                    }
                });
        runner.run();
        assertThat(seen).hasSizeGreaterThan(200);
    }

    private static void assertSame(DronePixels hits, int width, int height) {
        Mask mask = Mask.of(hits, width, height);
        int at = 0;
        boolean value = false;
        int zeros = 0;
        for (int i = 0; i < mask.counts().size(); i++) {
            zeros += i > 0 && mask.counts().get(i) == 0 ? 1 : 0;
            for (int k = 0; k < mask.counts().get(i); k++, at++) {
                assertThat(hits.isHit(at / height, at % height)).isEqualTo(value);
            }
            value = !value;
        }
        assertThat(zeros).isZero();
        assertThat(at).isEqualTo(width * height);
    }

    @Test
    void wrongCamerasAndTooManyPicturesAreRefusedInOneLine() {
        String out = directory.resolve("r").toString();
        assertThat(run(2, "run", "multi-sensor", "--labels", "microphone", "--out", out))
                .contains("--labels microphone: does not take pictures in colour (acoustic); colour cameras that are"
                        + " switched on: north-east-1");
        assertThat(run(2, "run", "multi-sensor", "--labels", "nobody", "--out", out))
                .contains("--labels nobody: no such camera; colour cameras that are switched on: north-east-1");
        assertThat(run(2, "run", "scenes/daylight.yaml", "--labels", "west", "--labels", "west", "--out", out))
                .contains("--labels west: is given twice");
        assertThat(run(
                        2,
                        "run",
                        "scenes/daylight.yaml",
                        "--labels",
                        "west",
                        "--set",
                        "run.duration=10h",
                        "--set",
                        "sensors.west.rate=10",
                        "--out",
                        out))
                .contains("--labels: asks for 360001 pictures with 331777 megapixels in all; at most 100000 pictures");
        assertThat(run(2, "run", "scenes/daylight.yaml", "--samples", "3", "--out", out))
                .contains("--samples 3: has no effect without --labels");
        assertThat(run(2, "run", "scenes/daylight.yaml", "--labels", "west", "--samples", "9", "--out", out))
                .contains("--samples 9: must be 1 to 8");
        assertThat(directory.resolve("r")).doesNotExist();
    }

    /** A run without labels into the same directory takes those of the run before away, but nothing else. */
    @Thorough
    @Test
    void labelsOfAnEarlierRunDoNotStay() throws IOException {
        String[] quick = {
            "run",
            "scenes/daylight.yaml",
            "--set",
            "run.duration=1",
            "--labels",
            "west",
            "--samples",
            "1",
            "--set",
            "sensors.garden.enabled=false",
            "--set",
            "sensors.west.width=64",
            "--set",
            "sensors.west.height=36"
        };
        String[] unlabelled = {
            "run",
            "scenes/daylight.yaml",
            "--set",
            "run.duration=1",
            "--set",
            "sensors.garden.enabled=false",
            "--set",
            "sensors.west.width=64",
            "--set",
            "sensors.west.height=36",
            "--out",
            directory.resolve("r").toString()
        };
        coco(quick);
        assertThat(directory.resolve("r/labels/west/000002.png")).exists();
        run(0, unlabelled);
        assertThat(directory.resolve("r/labels")).doesNotExist();
        assertThat(directory.resolve("r/coco.json")).doesNotExist();

        coco(quick);
        Path own = directory.resolve("r/labels/west/mine.png");
        Files.writeString(own, "mine");
        run(0, unlabelled);
        assertThat(directory.resolve("r/labels/west/000002.png")).doesNotExist();
        assertThat(own).exists();
    }

    @Thorough
    @Test
    void labelsAreTheSameForAnyNumberOfThreads() throws IOException {
        String[] quick = {
            "run",
            "scenes/daylight.yaml",
            "--set",
            "run.duration=3",
            "--labels",
            "west",
            "--set",
            "sensors.garden.enabled=false",
            "--set",
            "sensors.west.width=160",
            "--set",
            "sensors.west.height=90",
            "--threads"
        };
        Map<String, byte[]> one = bytes("one", quick, "1");
        Map<String, byte[]> four = bytes("four", quick, "4");
        assertThat(four).containsOnlyKeys(one.keySet()).hasSize(8);
        one.forEach((name, bytes) -> assertThat(four.get(name)).as(name).isEqualTo(bytes));
    }

    /** Rays added for the colours change pictures, and neither masks nor boxes, which are the sensor's own. */
    @Test
    void samplesSmoothColoursOnly() throws IOException {
        String[] quick = {
            "run",
            "scenes/daylight.yaml",
            "--set",
            "run.duration=3",
            "--set",
            "sensors.garden.enabled=false",
            "--set",
            "sensors.west.width=" + LongForm.count(240, 480),
            "--set",
            "sensors.west.height=" + LongForm.count(135, 270),
            "--threads",
            "2",
            "--labels",
            "west",
            "--samples"
        };
        Map<String, byte[]> one = bytes("one-sample", quick, "1");
        Map<String, byte[]> three = bytes("three-samples", quick, "3");
        assertThat(three).containsOnlyKeys(one.keySet());
        one.forEach((name, bytes) -> {
            if (name.equals("coco.json")) {
                assertThat(three.get(name)).isEqualTo(bytes);
                assertThat(new String(bytes, StandardCharsets.UTF_8)).contains("\"counts\"");
            } else {
                assertThat(three.get(name)).as(name).isNotEqualTo(bytes);
            }
        });
    }

    private Map<String, byte[]> bytes(String name, String[] command, String last) throws IOException {
        Path out = directory.resolve(name);
        run(
                0,
                Stream.concat(Stream.of(command), Stream.of(last, "--out", out.toString()))
                        .toArray(String[]::new));
        Map<String, byte[]> bytes = new HashMap<>();
        bytes.put("coco.json", Files.readAllBytes(out.resolve("coco.json")));
        try (Stream<Path> files = Files.list(out.resolve("labels/west"))) {
            for (Path file : files.toList()) {
                bytes.put(file.getFileName().toString(), Files.readAllBytes(file));
            }
        }
        return bytes;
    }
}
