package org.dronewatch.analysis.field;

import java.util.List;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;

/** The point towards which an inbound drone flies. */
public final class InboundTarget {
    private InboundTarget() {}

    /**
     * The middle of the protected zone, m: of the sphere, if there is one, or of the first area. Without a zone, the
     * mean position of the enabled sensors.
     *
     * @throws InputException when there is neither a zone nor a sensor
     */
    public static Position of(SceneSettings settings, Protection protection) {
        if (protection.zone().isPresent()) {
            return protection.zone().get().centre();
        }
        return protection.areas().stream()
                .findFirst()
                .map(InboundTarget::middle)
                .orElseGet(() -> sensors(settings));
    }

    private static Position middle(AreaZone area) {
        List<Position> corners = area.outline().stream()
                .map(corner -> new Position(corner.x(), corner.y(), 0.5 * (area.bottom() + area.top())))
                .toList();
        return mean(corners);
    }

    /**
     * The mean position of the enabled sensors, m.
     *
     * @throws InputException when there is none
     */
    public static Position sensors(SceneSettings settings) {
        if (settings.enabledSensors().isEmpty()) {
            throw new InputException("the scene has no sensors");
        }
        return mean(settings.enabledSensors().values().stream()
                .map(sensor -> sensor.position())
                .toList());
    }

    private static Position mean(List<Position> points) {
        Position sum = new Position(0, 0, 0);
        for (Position point : points) {
            sum = sum.plus(point);
        }
        return sum.times(1.0 / points.size());
    }
}
