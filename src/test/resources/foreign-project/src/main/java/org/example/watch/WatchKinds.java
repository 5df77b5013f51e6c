package org.example.watch;

import java.util.List;
import org.dronewatch.drone.SoundEmission;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.sensor.acoustic.propagation.Propagation;
import org.dronewatch.sensor.camera.DetectionFunction;
import org.dronewatch.setting.Kind;
import org.dronewatch.setting.KindGroup;

/** Four kinds at once. */
public final class WatchKinds implements KindGroup {
    @Override
    public List<Kind<?>> kinds() {
        return List.of(
                Kind.of(FlightPathSettings.class, "zigzag", Zigzag.class, "southward, swaying"),
                Kind.of(SoundEmission.class, "hum", Hum.class, "louder the faster it flies"),
                Kind.of(Propagation.class, "spherical", SphericalSpreading.class, "spreading alone"),
                Kind.of(DetectionFunction.class, "any-pixel", AnyPixel.class, "one pixel is enough"));
    }
}
