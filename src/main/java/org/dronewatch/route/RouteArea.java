package org.dronewatch.route;

import java.util.stream.DoubleStream;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/** The square in which routes are searched for unless another is given. */
public final class RouteArea {
    /** How far beyond the last point at which a detection is in time the square reaches, m. */
    private static final double BEYOND = 250.0;

    private RouteArea() {}

    /**
     * The side of a square around the centre of the protected zone or, without one, around the mean position of the
     * sensors. Half the side is the distance to the farthest point of the zones, plus the distance that a drone covers
     * during the response to a detection, plus 250 m, but at most the distance from the centre to the farthest side of
     * the site's bounds.
     *
     * @param drone name of the drone
     * @return the length of the side, m
     * @throws org.dronewatch.setting.InputException when there is neither a zone nor a sensor
     */
    public static double side(SceneSettings settings, Stage stage, String drone) {
        Position middle = InboundTarget.of(settings, stage.protection());
        double speed = DetectionField.droneOf(stage, drone).settings().speed();
        double wanted =
                zones(stage.protection(), middle) + speed * settings.alert().response() + BEYOND;
        AABB site = stage.world().bounds();
        double most = Math.max(
                Math.max(middle.x() - site.minX(), site.maxX() - middle.x()),
                Math.max(middle.y() - site.minY(), site.maxY() - middle.y()));
        return 2.0 * Math.ceil(Math.min(wanted, Math.max(1.0, most)));
    }

    /** The distance from the centre to the farthest corner of a protected zone, in plan view, m. */
    private static double zones(Protection protection, Position middle) {
        DoubleStream corners = protection.areas().stream()
                .flatMap(area -> area.outline().stream())
                .mapToDouble(corner -> Math.hypot(corner.x() - middle.x(), corner.y() - middle.y()));
        DoubleStream ball = protection.zone().stream()
                .mapToDouble(zone -> zone.radius()
                        + Math.hypot(
                                zone.centre().x() - middle.x(), zone.centre().y() - middle.y()));
        return DoubleStream.concat(corners, ball).max().orElse(0.0);
    }
}
