package org.dronewatch.catalog;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.DetectionFunction;
import org.dronewatch.sensor.camera.PixelThreshold;
import org.dronewatch.sensor.camera.TargetTask;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.rf.RfSettings;
import org.dronewatch.sensor.thermal.ThermalSettings;
import org.dronewatch.setting.file.Kinds;

/** The kinds of sensors that files may name. A new kind is one more line here. */
public final class SensorKinds {
    private static final Map<String, Class<? extends Record>> SENSORS = new LinkedHashMap<>();

    static {
        SENSORS.put("camera", CameraSettings.class);
        SENSORS.put("acoustic", AcousticSettings.class);
        SENSORS.put("radar", RadarSettings.class);
        SENSORS.put("rf", RfSettings.class);
        SENSORS.put("thermal", ThermalSettings.class);
    }

    /** Parts of sensors of which there are several kinds, where anyone may add one. */
    private static final Map<Class<?>, Map<String, Class<? extends Record>>> PARTS =
            Map.of(DetectionFunction.class, new LinkedHashMap<>());

    static {
        PARTS.get(DetectionFunction.class).put("pixel-threshold", PixelThreshold.class);
        PARTS.get(DetectionFunction.class).put("target-task", TargetTask.class);
    }

    private SensorKinds() {}

    /** The kinds of parts of sensors by their names, for each interface that anyone may implement. */
    public static Map<Class<?>, Map<String, Class<? extends Record>>> parts() {
        Map<Class<?>, Map<String, Class<? extends Record>>> parts = new LinkedHashMap<>();
        PARTS.forEach((type, kinds) -> parts.put(type, Collections.unmodifiableMap(kinds)));
        return parts;
    }

    /** The settings of each kind by its name. */
    public static Map<String, Class<? extends Record>> all() {
        return Collections.unmodifiableMap(SENSORS);
    }

    /**
     * What settings files need to know to read sensors.
     *
     * @param catalog where {@code use} finds them by name
     */
    public static Kinds kinds(Catalog catalog) {
        Kinds kinds = Kinds.SEALED
                .with(SensorSettings.class, catalog)
                .with(SensorSettings.class, SENSORS)
                .with(PositionerSettings.class, new Positioners());
        for (Map.Entry<Class<?>, Map<String, Class<? extends Record>>> part : PARTS.entrySet()) {
            kinds = kinds.with(part.getKey(), part.getValue());
        }
        return kinds;
    }
}
