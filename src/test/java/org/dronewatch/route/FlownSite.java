package org.dronewatch.route;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A real scene in which routes are proved by flight.
 *
 * @param scene a file, or the name of a packaged scene
 * @param overrides as of {@code --set}
 * @param drone the one that flies
 * @param side of the field in which routes are searched for, m
 * @param cell edge of its cells, m
 * @param crossSection of the drone, with which the radars do not detect it for certain on these routes, m2
 */
record FlownSite(
        String name,
        String scene,
        Map<String, String> overrides,
        String drone,
        double side,
        double cell,
        double crossSection) {
    /** Each look of the microphone takes up to a tenth of a second. */
    private static final Map<String, String> NO_MICROPHONE = Map.of("sensors.microphone.enabled", "false");

    /** The receiver leaves nothing to chance. */
    private static final Map<String, String> NO_RECEIVER = Map.of("sensors.radio.enabled", "false");

    private static final Map<String, String> NEITHER =
            Map.of("sensors.microphone.enabled", "false", "sensors.radio.enabled", "false");

    /** At the camera, which otherwise leaves nothing to chance. */
    private static final Map<String, String> OBSERVER = observer("camera");

    /** At both cameras. */
    private static final Map<String, String> OBSERVERS = observers(List.of("garden", "west"));

    /** At the camera, without the microphone. */
    private static final Map<String, String> OBSERVER_ALONE = new LinkedHashMap<>(OBSERVER);

    static {
        OBSERVER_ALONE.put("sensors.microphone.enabled", "false");
    }

    /** Of the build. */
    static final FlownSite SHORT =
            new FlownSite("meadow", "scenes/meadow.yaml", NO_RECEIVER, "intruder", 3000, 150, 0.01);

    /** Of the long form, with the weakest routes. */
    static final List<FlownSite> LONG = List.of(
            new FlownSite("hill-radar", "scenes/hill-radar.yaml", Map.of(), "quadrotor", 1000, 40, 0.01),
            new FlownSite("cued-camera", "scenes/cued-camera.yaml", Map.of(), "intruder", 800, 40, 1e-6),
            new FlownSite("multi-sensor", "multi-sensor", NO_MICROPHONE, "quadrotor", 400, 10, 0.01),
            new FlownSite("multi-sensor-observers", "multi-sensor", observers(), "quadrotor", 400, 10, 0.01),
            new FlownSite("meadow", "scenes/meadow.yaml", NO_RECEIVER, "intruder", 3000, 100, 0.01),
            new FlownSite("glider", "scenes/glider.yaml", Map.of(), "glider", 1200, 40, 1e-4),
            new FlownSite("palace", "scenes/palace.yaml", Map.of(), "intruder", 2400, 80, 1e-3),
            new FlownSite("birds", "scenes/birds.yaml", Map.of(), "intruder", 1200, 40, 1e-3),
            new FlownSite("false-alarms", "scenes/false-alarms.yaml", Map.of(), "intruder", 1200, 40, 1e-3),
            new FlownSite("radar-clutter", "scenes/radar-clutter.yaml", Map.of(), "coming", 1200, 40, 1e-2),
            new FlownSite("camera-range", "camera-range", OBSERVER, "quadrotor", 500, 20, 0.01),
            new FlownSite("daylight", "scenes/daylight.yaml", OBSERVERS, "quadrotor", 400, 20, 0.01),
            new FlownSite("closed-space", "scenes/closed-space.yaml", OBSERVER_ALONE, "quadrotor", 40, 2, 0.01),
            new FlownSite("listening-post", "scenes/listening-post.yaml", Map.of(), "intruder", 800, 50, 0.01),
            new FlownSite("acoustic-range", "acoustic-range", Map.of(), "quadrotor", 500, 50, 0.01),
            monaco("monaco", NO_MICROPHONE, 2400, 80),
            monaco("monaco-without-receiver", NEITHER, 2400, 80));

    /** With a microphone whose looks take long, only for a few random flights. */
    static final List<FlownSite> HEARD = List.of(
            monaco("monaco-microphone", others(), 1200, 300),
            new FlownSite("multi-sensor-microphone", "multi-sensor", noCameras(), "quadrotor", 300, 30, 0.01));

    private static FlownSite monaco(String name, Map<String, String> overrides, double side, double cell) {
        return new FlownSite(name, "scenes/monaco.yaml", overrides, "from-the-sea", side, cell, 1e-4);
    }

    /** All sensors of Monaco but the microphone are off. */
    private static Map<String, String> others() {
        Map<String, String> overrides = new LinkedHashMap<>(NO_RECEIVER);
        for (String other : List.of("radar-sea", "radar-mountain", "camera", "thermal")) {
            overrides.put("sensors." + other + ".enabled", "false");
        }
        return overrides;
    }

    /** At each of the twelve cameras, which otherwise leave nothing to chance. */
    private static Map<String, String> observers() {
        Map<String, String> overrides = new LinkedHashMap<>(NO_MICROPHONE);
        overrides.putAll(observers(cameras()));
        return overrides;
    }

    private static Map<String, String> observers(List<String> cameras) {
        Map<String, String> overrides = new LinkedHashMap<>();
        cameras.forEach(camera -> overrides.putAll(observer(camera)));
        return overrides;
    }

    private static Map<String, String> noCameras() {
        Map<String, String> overrides = new LinkedHashMap<>();
        cameras().forEach(camera -> overrides.put("sensors." + camera + ".enabled", "false"));
        return overrides;
    }

    /** The names of those of {@code multi-sensor}. */
    private static List<String> cameras() {
        List<String> cameras = new ArrayList<>();
        for (String corner : List.of("north-east", "south-east", "south-west", "north-west")) {
            for (int camera = 1; camera <= 3; camera++) {
                cameras.add(corner + "-" + camera);
            }
        }
        return cameras;
    }

    private static Map<String, String> observer(String camera) {
        String detection = "sensors." + camera + ".detection";
        Map<String, String> overrides = new LinkedHashMap<>();
        overrides.put(detection, "target-task");
        overrides.put(detection + ".task", "identification");
        return overrides;
    }

    @Override
    public String toString() {
        return name;
    }
}
