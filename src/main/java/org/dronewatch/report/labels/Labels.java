package org.dronewatch.report.labels;

import java.io.BufferedOutputStream;
import java.io.BufferedWriter;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.dronewatch.drone.Drone;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.optics.DronePixels;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * Writes each look of some cameras as a picture, and the drones in them as {@code coco.json}, in the COCO
 * object-detection format: one annotation for each drone that at least one pixel shows, with a mask of the pixels that
 * the sensor counts as showing the drone. Looks are written during the run; images and annotations are numbered in the
 * order of runs, cameras, looks and drones.
 */
public final class Labels implements AutoCloseable {
    /** Name of the file with all annotations. */
    public static final String COCO = "coco.json";

    /** Name of the directory of pictures. */
    public static final String PICTURES = "labels";

    private static final JsonMapper MAPPER = JsonMapper.builder().build();
    private static final int DECIMALS = 6;

    /** The destination of files. */
    @FunctionalInterface
    public interface Target {
        /** The path of a file of the results; its directory exists. */
        Path file(String name) throws IOException;
    }

    private final LabelPlan plan;
    private final Target target;
    private final List<LabelledCamera> cameras = new ArrayList<>();

    /** What the cameras saw: for each run and camera a part, in this order. */
    private final List<LabelPart> parts = new ArrayList<>();

    /** The parts of the cameras in the current run. */
    private final List<LabelPart> open = new ArrayList<>();

    private boolean several;
    private boolean hasBirds;

    /** Labels according to a plan. */
    public Labels(LabelPlan plan, Target target) {
        this.plan = plan;
        this.target = target;
    }

    /** Begins a run. */
    public void runStarted(RunInfo run, Stage stage) throws IOException {
        closeParts();
        cameras.clear();
        several = run.runs() > 1;
        hasBirds |= !run.settings().birds().isEmpty();
        for (String id : plan.cameras()) {
            cameras.add(new LabelledCamera(id, run.settings().sensors().get(id), stage, plan.samples()));
            String part = PICTURES + "/part-" + parts.size();
            open.add(new LabelPart(target.file(part + "-images"), target.file(part + "-annotations")));
            parts.add(open.get(open.size() - 1));
        }
    }

    /** Writes the pictures of those cameras that take a look at the time of a frame. */
    public void observed(Frame frame) throws IOException {
        for (int i = 0; i < cameras.size(); i++) {
            LabelledCamera camera = cameras.get(i);
            long look = camera.look(frame);
            if (look >= 0) {
                String name = name(frame.run(), camera.id(), look);
                writePng(camera, frame, target.file(name));
                List<ObjectNode> annotations = new ArrayList<>();
                List<DronePixels> hits = camera.hits(frame);
                for (int drone = 0; drone < hits.size(); drone++) {
                    if (hits.get(drone).count() > 0) {
                        annotations.add(annotation(frame, camera, frame.drones().get(drone), hits.get(drone)));
                    }
                }
                open.get(i).add(image(frame, camera, look, name), annotations);
            }
        }
    }

    private String name(int run, String camera, long look) {
        String ofRun = several ? "run-" + run + "/" : "";
        return String.format(Locale.ROOT, "%s/%s%s/%06d.png", PICTURES, ofRun, camera, look);
    }

    private static void writePng(LabelledCamera camera, Frame frame, Path file) throws IOException {
        // Not a channel, because an interrupt would close it.
        try (OutputStream stream = new BufferedOutputStream(new FileOutputStream(file.toFile()))) {
            ImageIO.write(camera.photo(frame), "png", stream);
        }
    }

    private static ObjectNode image(Frame frame, LabelledCamera camera, long look, String name) {
        ObjectNode image = JsonNodeFactory.instance.objectNode();
        image.put("file_name", name);
        image.put("width", camera.camera().width());
        image.put("height", camera.camera().height());
        image.put("run", frame.run());
        image.put("camera", camera.id());
        image.put("look", look);
        image.put("time_s", rounded(frame.time()));
        return image;
    }

    private static ObjectNode annotation(Frame frame, LabelledCamera camera, Drone drone, DronePixels hits) {
        int width = camera.camera().width();
        int height = camera.camera().height();
        Mask mask = Mask.of(hits, width, height);
        ObjectNode annotation = JsonNodeFactory.instance.objectNode();
        annotation.put("category_id", drone.settings().isBird() ? 2 : 1);
        annotation
                .putArray("bbox")
                .add(mask.left())
                .add(mask.top())
                .add(mask.width())
                .add(mask.height());
        annotation.put("area", hits.count());
        annotation.put("iscrowd", 0);
        annotation.put("run", frame.run());
        annotation.put("time_s", rounded(frame.time()));
        annotation.put("drone", drone.id());
        annotation.put("range_m", rounded(drone.distance(camera.camera().position())));
        ObjectNode segmentation = annotation.putObject("segmentation");
        segmentation.putArray("size").add(height).add(width);
        ArrayNode counts = segmentation.putArray("counts");
        mask.counts().forEach(counts::add);
        return annotation;
    }

    private static BigDecimal rounded(double value) {
        BigDecimal shortest = BigDecimal.valueOf(value)
                .setScale(DECIMALS, RoundingMode.HALF_EVEN)
                .stripTrailingZeros();
        return shortest.scale() < 0 ? shortest.setScale(0) : shortest;
    }

    /** Writes {@code coco.json} for all pictures. */
    public void finish(String scene) throws IOException {
        closeParts();
        ObjectNode info = JsonNodeFactory.instance.objectNode();
        info.put("description", "Drones in the pictures taken by the cameras of the scene '" + scene + "'");
        try (BufferedWriter coco = Files.newBufferedWriter(target.file(COCO), StandardCharsets.UTF_8)) {
            coco.write("{\n\"info\": " + MAPPER.writeValueAsString(info) + ",\n\"licenses\": [],\n");
            String birds = hasBirds ? ",{\"id\":2,\"name\":\"bird\",\"supercategory\":\"animal\"}" : "";
            coco.write(
                    "\"categories\": [{\"id\":1,\"name\":\"drone\",\"supercategory\":\"aircraft\"}" + birds + "],\n");
            coco.write("\"images\": [");
            long images = 0;
            for (LabelPart part : parts) {
                images = part.copyImages(coco, images);
            }
            coco.write("\n],\n\"annotations\": [");
            images = 0;
            long annotations = 0;
            for (LabelPart part : parts) {
                annotations = part.copyAnnotations(coco, annotations, images);
                images += part.images();
            }
            coco.write("\n]\n}\n");
        }
        for (LabelPart part : parts) {
            part.delete();
        }
    }

    private void closeParts() throws IOException {
        IOException problem = null;
        for (LabelPart part : open) {
            try {
                part.close();
            } catch (IOException e) {
                problem = problem == null ? e : problem;
            }
        }
        open.clear();
        if (problem != null) {
            throw problem;
        }
    }

    /**
     * Closes the label files; the target has to remove unfinished ones.
     *
     * @throws UncheckedIOException when the last lines cannot be written
     */
    @Override
    public void close() {
        try {
            closeParts();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
