package org.dronewatch.analysis.field;

import java.util.List;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.ProtectedZone;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;

/** The point towards which an inbound drone flies. */
public final class InboundTarget {
    private InboundTarget() {}

    /**
     * The centre of the protected zone, m: of the sphere, if there is one, or of the first area. Without a zone, the
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

    /**
     * The centre of the area of a grid, m; without an area, the centre of the protected zone or, without a zone, the
     * mean position of the sensors.
     *
     * @throws InputException when there is neither an area, nor a zone, nor a sensor
     */
    public static Position of(SceneSettings settings, Protection protection, FieldGrid grid) {
        return grid.area().map(area -> of(protection, area.name())).orElseGet(() -> of(settings, protection));
    }

    /**
     * The centre of one of the protected zones, m.
     *
     * @param name an area, or {@link Protection#ZONE} for the sphere
     * @throws InputException when there is none of that name
     */
    private static Position of(Protection protection, String name) {
        return protection.areas().stream()
                .filter(area -> area.name().equals(name))
                .findFirst()
                .map(InboundTarget::middle)
                .or(() -> protection
                        .zone()
                        .filter(ball -> name.equals(Protection.ZONE))
                        .map(ProtectedZone::centre))
                .orElseThrow(() -> new InputException("no protected zone '" + name + "'"));
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
     * @throws InputException when there is no enabled sensor
     */
    public static Position sensors(SceneSettings settings) {
        if (settings.enabledSensors().isEmpty()) {
            throw new InputException("the scene has no sensor that is switched on");
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
