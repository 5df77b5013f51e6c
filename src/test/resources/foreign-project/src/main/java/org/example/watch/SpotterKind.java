package org.example.watch;

import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Kind;

/** One kind, by a provider of its own. */
public final class SpotterKind implements Kind<SensorSettings<?>> {
    @Override
    public Class<? super SensorSettings<?>> type() {
        return SensorSettings.class;
    }

    @Override
    public String name() {
        return "spotter";
    }

    @Override
    public Class<SpotterSettings> settings() {
        return SpotterSettings.class;
    }

    @Override
    public String summary() {
        return "someone with binoculars";
    }
}
