package org.dronewatch.sensor.radio;

import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.World;

/**
 * The path loss of a radio wave between two positions in a site: free-space loss, and diffraction at the edges of the
 * mesh. A wave is diffracted over an obstacle and round it on both sides, and the powers of the three paths are added
 * (ITU-R P.526-15, section 4.2, average loss of a screen of finite width). Edges near an unobstructed line also
 * attenuate the wave. One per thread.
 */
public final class RadioPath {
    private static final double LIGHT = 299_792_458.0;

    /** Paths past either side are searched for up to this detour, as a multiple of the distance and in metres. */
    private static final double DETOUR = 1.25;

    private static final double LEAST_DETOUR = 100.0;

    /**
     * Without anything in the line, edges count up to 0.55 radii of the first Fresnel zone from it, and others up to as
     * far from the line to such an edge: within 1.1 radii in all, a detour of 0.61 wavelengths or, at an antenna, 1.1.
     */
    private static final double NEAR = 2.0;

    /** An edge with a loss of 40 dB rises to 16 radii of the first Fresnel zone, a detour of this many wavelengths. */
    private static final double FAINT = 128.0;

    private final World world;
    private final Section upright;
    private final Section level;
    private int mainTriangle;

    /** Paths in a site. */
    public RadioPath(World world) {
        this.world = world;
        this.upright = new Section(world);
        this.level = new Section(world);
    }

    /**
     * Loss in free space between isotropic antennas: {@code 20 lg(4 pi d f / c)} (ITU-R P.525).
     *
     * @param distance above 0, m
     * @param frequency Hz
     * @return dB
     */
    public static double freeSpaceLoss(double distance, double frequency) {
        return 20.0 * Math.log10(4.0 * Math.PI * distance * frequency / LIGHT);
    }

    /**
     * The diffraction loss between two positions, dB; infinite if there is no path round the obstacle, as into a closed
     * room.
     *
     * @param from one antenna, m
     * @param to the other, m
     * @param frequency Hz
     */
    public double obstacleLoss(Position from, Position to, double frequency) {
        double length = from.distance(to);
        double tall = world.bounds().maxZ() - world.bounds().minZ();
        return loss(from, to, frequency, DETOUR * length + 2.0 * tall, DETOUR * length + LEAST_DETOUR);
    }

    /**
     * The same for a wave that matters only as long as it is not much weaker than another one: infinite from about 40
     * dB on, and found in less time.
     */
    double faintLoss(Position from, Position to, double frequency) {
        double farthest = from.distance(to) + FAINT * LIGHT / frequency;
        return loss(from, to, frequency, farthest, farthest);
    }

    private double loss(Position from, Position to, double frequency, double over, double beside) {
        mainTriangle = -1;
        double length = from.distance(to);
        if (!(length > 0.0)) {
            return 0.0;
        }
        double wavelength = LIGHT / frequency;
        double near = length + NEAR * wavelength;
        cut(from, to, near, near);
        if (upright.isBlocked() || level.isBlocked()) {
            cut(from, to, over, beside);
        }
        return ofSections(wavelength);
    }

    private void cut(Position from, Position to, double over, double beside) {
        Position ahead = to.minus(from).times(1.0 / from.distance(to));
        Position up = upwards(ahead);
        upright.cut(from, to, ahead, up, over);
        level.cut(from, to, ahead, up.cross(ahead), beside);
    }

    private double ofSections(double wavelength) {
        DiffractedPath over = new DiffractedPath(upright, true, wavelength);
        DiffractedPath left = new DiffractedPath(level, true, wavelength);
        DiffractedPath right = new DiffractedPath(level, false, wavelength);
        boolean isBlocked = upright.isBlocked() || level.isBlocked();
        DiffractedPath main = over;
        for (DiffractedPath path : List.of(left, right)) {
            boolean isMain = isBlocked ? path.loss() < main.loss() : path.loss() > main.loss();
            main = isMain ? path : main;
        }
        mainTriangle = main.triangle();
        return isBlocked ? ofBlocked(over, left, right) : over.loss() + left.loss() + right.loss();
    }

    /** By rounding, a line along an edge may be blocked in one section only: then the paths in that one count. */
    private double ofBlocked(DiffractedPath over, DiffractedPath left, DiffractedPath right) {
        double beside = left.loss() + right.loss();
        if (!level.isBlocked()) {
            return beside > 0.0 ? Math.min(over.loss(), beside) : over.loss();
        }
        double power = Math.pow(10.0, -0.1 * left.loss()) + Math.pow(10.0, -0.1 * right.loss());
        if (upright.isBlocked()) {
            power += Math.pow(10.0, -0.1 * over.loss());
        }
        double round = Math.max(0.0, -10.0 * Math.log10(power));
        return !upright.isBlocked() && over.loss() > 0.0 ? Math.min(over.loss(), round) : round;
    }

    /** Perpendicular to a direction, of length 1, as upright as possible. */
    private static Position upwards(Position ahead) {
        boolean isSteep = Math.hypot(ahead.x(), ahead.y()) < 1e-6;
        Position up = isSteep ? new Position(0.0, 1.0, 0.0) : new Position(0.0, 0.0, 1.0);
        Position across = up.minus(ahead.times(up.dot(ahead)));
        return across.times(1.0 / across.length());
    }

    /** The model with the edge of the greatest loss between two positions; empty if no edge is near the line. */
    public Optional<Obstacle> obstacle(Position from, Position to, double frequency) {
        obstacleLoss(from, to, frequency);
        return mainTriangle < 0 ? Optional.empty() : Optional.of(world.obstacle(mainTriangle));
    }

    /** The site. */
    public World world() {
        return world;
    }
}
