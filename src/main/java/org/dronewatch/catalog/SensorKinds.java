package org.dronewatch.catalog;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.DetectionFunction;
import org.dronewatch.sensor.camera.PixelThreshold;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.setting.file.Kinds;

/** The kinds of sensors that files may name. A new kind is one more line here. */
public final class SensorKinds {
    private static final Map<String, Class<? extends Record>> SENSORS = new LinkedHashMap<>();

    static {
        SENSORS.put("camera", CameraSettings.class);
        SENSORS.put("acoustic", AcousticSettings.class);
        SENSORS.put("radar", RadarSettings.class);
    }

    private SensorKinds() {}

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
        return Kinds.SEALED
                .with(SensorSettings.class, catalog)
                .with(SensorSettings.class, SENSORS)
                .with(DetectionFunction.class, Map.of("pixel-threshold", PixelThreshold.class));
    }
}
