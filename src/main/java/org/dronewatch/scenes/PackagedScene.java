package org.dronewatch.scenes;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.dronewatch.scene.Scene;

/**
 * A scene of the library, which can be run by its name.
 *
 * @param name name of the scene on the command line
 * @param summary one line on what it shows
 * @param factory creates a new instance
 */
public record PackagedScene(String name, String summary, Supplier<Scene> factory) {
    private static final List<PackagedScene> ALL = List.of(
            new PackagedScene(
                    "closed-space",
                    "a quadrotor hovers in a church, 10 m from a camera and a microphone; both detect it",
                    ClosedSpace::new),
            new PackagedScene(
                    "camera-range",
                    "a quadrotor flies towards a full HD camera on a hill; range of first detection for five fields of view",
                    CameraRange::new),
            new PackagedScene(
                    "acoustic-range",
                    "a quadrotor flies towards a microphone on a hill; range of first detection for five levels of background noise",
                    AcousticRange::new),
            new PackagedScene(
                    "multi-sensor",
                    "a quadrotor flies towards a house on a hill with twelve cameras and a microphone on its roof",
                    MultiSensor::new));

    /** All packaged scenes, in the order in which they are listed. */
    public static List<PackagedScene> all() {
        return ALL;
    }

    /** The scene with this name. */
    public static Optional<PackagedScene> find(String name) {
        return ALL.stream().filter(scene -> scene.name().equals(name)).findFirst();
    }
}
