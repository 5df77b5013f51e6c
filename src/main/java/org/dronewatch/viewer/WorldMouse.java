package org.dronewatch.viewer;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Orbit;

/** Mouse control of the site view, and of what is gripped in it. */
final class WorldMouse extends MouseAdapter {
    /** The angle by which dragging across the whole width turns the view, rad. */
    private static final double TURN = Math.toRadians(240.0);

    /** The factor by which one click of the wheel shortens the distance from the eye to the target. */
    private static final double ZOOM = 0.85;

    private final WorldPanel panel;
    private int lastX;
    private int lastY;
    private boolean isGripping;

    WorldMouse(WorldPanel panel) {
        this.panel = panel;
    }

    @Override
    public void mousePressed(MouseEvent e) {
        lastX = e.getX();
        lastY = e.getY();
        panel.requestFocusInWindow();
        boolean isPlain = SwingUtilities.isLeftMouseButton(e) && !e.isShiftDown() && !e.isControlDown();
        isGripping = isPlain && !panel.tool().isOn() && panel.grip().isAt(e.getX(), e.getY());
        if (isGripping) {
            panel.grip().take(e.getX(), e.getY());
        }
    }

    @Override
    public void mouseReleased(MouseEvent e) {
        isGripping = false;
    }

    @Override
    public void mouseClicked(MouseEvent e) {
        if (!SwingUtilities.isLeftMouseButton(e)) {
            return;
        }
        if (e.getClickCount() == 2 && !panel.tool().isOn()) {
            panel.placeAt(e.getX(), e.getY())
                    .ifPresent(point -> panel.move(panel.orbit().at(point).zoomed(0.6)));
        } else {
            panel.select(e.getX(), e.getY());
        }
    }

    @Override
    public void mouseDragged(MouseEvent e) {
        Orbit orbit = panel.orbit();
        if (isGripping) {
            panel.grip().drag(e.getX(), e.getY());
        }
        if (orbit == null || isGripping) {
            return;
        }
        int dx = e.getX() - lastX;
        int dy = e.getY() - lastY;
        lastX = e.getX();
        lastY = e.getY();
        boolean pans = !SwingUtilities.isLeftMouseButton(e) || e.isShiftDown();
        if (pans) {
            double metres = orbit.metresPerPixel(panel.getHeight());
            panel.move(orbit.panned(-dx * metres, dy * metres));
        } else {
            double turn = TURN / Math.max(1, panel.getWidth());
            panel.move(
                    e.isControlDown() ? orbit.lookedAbout(dx * turn, -dy * turn) : orbit.turned(dx * turn, dy * turn));
        }
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent e) {
        Orbit orbit = panel.orbit();
        if (orbit == null) {
            return;
        }
        double factor = Math.pow(ZOOM, -e.getPreciseWheelRotation());
        // What is under the pointer stays there: the target moves towards it as the eye does.
        Optional<Position> point = panel.placeAt(e.getX(), e.getY());
        Position target = point.filter(p -> factor < 1.0)
                .map(p -> orbit.target().plus(aside(orbit, e).times(1.0 - factor)))
                .orElse(orbit.target());
        panel.move(orbit.at(target).zoomed(factor));
    }

    /** The vector from the middle of the picture to the pointer, in the plane through the target, m. */
    private Position aside(Orbit orbit, MouseEvent e) {
        double metres = orbit.metresPerPixel(panel.getHeight());
        double right = (e.getX() - 0.5 * panel.getWidth()) * metres;
        double up = (0.5 * panel.getHeight() - e.getY()) * metres;
        return orbit.panned(right, up).target().minus(orbit.target());
    }

    @Override
    public void mouseMoved(MouseEvent e) {
        panel.describe(e.getX(), e.getY());
    }
}
