package org.dronewatch.report;

import java.util.Locale;
import org.dronewatch.scene.SceneSettings;
import org.dronewatch.scene.SweepSettings;
import org.dronewatch.setting.SettingsPath;

/** The value that a swept setting has in one run, as people read it. */
public final class SweptValue {
    private final String parameter;
    private final Object value;
    private final String unit;

    /**
     * Reads the value.
     *
     * @param settings settings of the run
     * @param sweep what is swept
     */
    public SweptValue(SceneSettings settings, SweepSettings sweep) {
        SettingsPath path = new SettingsPath(sweep.parameter());
        this.parameter = sweep.parameter();
        this.value = sweep.valueIn(settings);
        this.unit = path.quantity(settings).unit();
    }

    /** With the whole path: {@code sensors.camera.fov=0.5236 rad}. */
    public String text() {
        return (parameter + "=" + number() + " " + unit).strip();
    }

    /** With the setting's own name only: {@code fov 0.5236 rad}. */
    public String shortText() {
        return (parameter.substring(parameter.lastIndexOf('.') + 1) + " " + number() + " " + unit).strip();
    }

    private String number() {
        return value instanceof Double number ? String.format(Locale.ROOT, "%.4g", number) : value.toString();
    }
}
