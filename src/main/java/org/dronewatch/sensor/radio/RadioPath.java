package org.dronewatch.sensor.radio;

import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.World;

/**
 * The path loss of a radio wave between two positions in a site: free-space loss, and diffraction at the edges of the
 * mesh. A wave is diffracted over an obstacle and around it on both sides, and the powers of the three paths are added
 * (ITU-R P.526-15, section 4.2, average loss of a screen of finite width). Edges near an unobstructed line also
 * attenuate the wave. For use by one thread.
 */
public final class RadioPath {
    private static final double LIGHT = 299_792_458.0;

    /** Paths past either side are searched for up to this detour, as a multiple of the distance and in metres. */
    private static final double DETOUR = 1.25;

    private static final double LEAST_DETOUR = 100.0;

    /**
     * If the line is unobstructed, edges within 0.55 radii of the first Fresnel zone of it count, and so do other edges
     * that are equally near to a line from an antenna to such an edge: all are within 1.1 radii, which is a detour of
     * 0.61 wavelengths or, at an antenna, of 1.1.
     */
    private static final double NEAR = 2.0;

    /** An edge with a loss of 40 dB rises to 16 radii of the first Fresnel zone, a detour of this many wavelengths. */
    private static final double FAINT = 128.0;

    /**
     * The detour up to which a blocked path is searched for first, m, and the factor by which it grows each time: over
     * most roofs, a few metres suffice, but houses that touch form long rows.
     */
    private static final double FIRST = 8.0;

    private static final double FARTHER = 16.0;

    private final World world;
    private final Section upright;
    private final Section level;

    /** Paths in a site. */
    public RadioPath(World world) {
        this.world = world;
        this.upright = new Section(world);
        this.level = new Section(world);
    }

    /** The line between two antennas, with the directions in which the two sections through it extend. */
    private record Line(Position from, Position to, double wavelength, Position ahead, Position up) {
        static Line of(Position from, Position to, double wavelength) {
            Position ahead = to.minus(from).times(1.0 / from.distance(to));
            return new Line(from, to, wavelength, ahead, upwards(ahead));
        }

        double length() {
            return from.distance(to);
        }

        /** Cuts the site in one of the sections, up to a sum of the distances from both ends, m. */
        void cut(Section section, boolean isUpright, double sum) {
            section.cut(from, to, ahead, isUpright ? up : up.cross(ahead), sum);
        }
    }

    /** The three paths, and whether the line is blocked in each of the two sections. */
    private record Paths(
            DiffractedPath over,
            DiffractedPath left,
            DiffractedPath right,
            boolean isUprightBlocked,
            boolean isLevelBlocked) {
        boolean isBlocked() {
            return isUprightBlocked || isLevelBlocked;
        }

        /**
         * The path that matters most: the one with the least loss if the line is blocked, or else the one with the
         * greatest.
         */
        DiffractedPath main() {
            DiffractedPath main = over;
            for (DiffractedPath path : List.of(left, right)) {
                boolean isMain = isBlocked() ? path.loss() < main.loss() : path.loss() > main.loss();
                main = isMain ? path : main;
            }
            return main;
        }

        double loss() {
            return isBlocked() ? ofBlocked() : over.loss() + left.loss() + right.loss();
        }

        /**
         * The loss if the line is blocked, dB. Because of rounding, a line along an edge may be blocked in one section
         * only; then the paths in that section count.
         */
        private double ofBlocked() {
            double beside = left.loss() + right.loss();
            if (!isLevelBlocked) {
                return beside > 0.0 ? Math.min(over.loss(), beside) : over.loss();
            }
            double power = Math.pow(10.0, -0.1 * left.loss()) + Math.pow(10.0, -0.1 * right.loss());
            if (isUprightBlocked) {
                power += Math.pow(10.0, -0.1 * over.loss());
            }
            double round = Math.max(0.0, -10.0 * Math.log10(power));
            return !isUprightBlocked && over.loss() > 0.0 ? Math.min(over.loss(), round) : round;
        }
    }

    /**
     * Loss in free space between isotropic antennas: {@code 20 lg(4 pi d f / c)}, where c is the speed of light (ITU-R
     * P.525).
     *
     * @param distance distance d, above 0, m
     * @param frequency carrier frequency f, Hz
     * @return the loss, dB
     */
    public static double freeSpaceLoss(double distance, double frequency) {
        return 20.0 * Math.log10(4.0 * Math.PI * distance * frequency / LIGHT);
    }

    /**
     * The diffraction loss between two positions, dB; infinite if there is no path around the obstacle, for instance
     * into a closed room.
     *
     * @param from position of one antenna, m
     * @param to position of the other antenna, m
     * @param frequency carrier frequency, Hz
     */
    public double obstacleLoss(Position from, Position to, double frequency) {
        return obstacleLoss(from, to, frequency, FIRST);
    }

    /**
     * The same loss, with another first step of the search, which does not affect the result.
     *
     * @param first the detour up to which a blocked path is searched for first, m
     */
    double obstacleLoss(Position from, Position to, double frequency, double first) {
        if (!(from.distance(to) > 0.0)) {
            return 0.0;
        }
        return paths(Line.of(from, to, LIGHT / frequency), over(from, to), beside(from, to), first)
                .loss();
    }

    /** The limit of the search for paths over an obstacle: the sum of the distances from both ends, m. */
    private double over(Position from, Position to) {
        double tall = world.bounds().maxZ() - world.bounds().minZ();
        return DETOUR * from.distance(to) + 2.0 * tall;
    }

    /**
     * The limit of the search for paths past either side of an obstacle: the sum of the distances from both ends, m.
     */
    private static double beside(Position from, Position to) {
        return DETOUR * from.distance(to) + LEAST_DETOUR;
    }

    /**
     * The diffraction loss of a wave that matters only as long as it is not much weaker than another one, dB: found in
     * less time, and infinite from about 40 dB on.
     */
    double faintLoss(Position from, Position to, double frequency) {
        double length = from.distance(to);
        if (!(length > 0.0)) {
            return 0.0;
        }
        double farthest = length + FAINT * LIGHT / frequency;
        return paths(Line.of(from, to, LIGHT / frequency), farthest, farthest, FIRST)
                .loss();
    }

    /**
     * The paths along a line.
     *
     * @param over limit of the search over an obstacle, as a sum of the distances from both ends, m
     * @param beside the same past either side, m
     * @param first the detour up to which a blocked path is searched for first, m
     */
    private Paths paths(Line line, double over, double beside, double first) {
        double near = line.length() + NEAR * line.wavelength();
        line.cut(upright, true, near);
        line.cut(level, false, near);
        boolean isUprightBlocked = upright.isBlocked();
        boolean isLevelBlocked = level.isBlocked();
        double wavelength = line.wavelength();
        if (!isUprightBlocked && !isLevelBlocked) {
            return new Paths(
                    new DiffractedPath(upright, true, wavelength, true),
                    new DiffractedPath(level, true, wavelength, true),
                    new DiffractedPath(level, false, wavelength, true),
                    false,
                    false);
        }
        DiffractedPath[] upwards = found(line, upright, over, first, true);
        DiffractedPath[] sideways = found(line, level, beside, first, true, false);
        return new Paths(upwards[0], sideways[0], sideways[1], isUprightBlocked, isLevelBlocked);
    }

    /**
     * The paths in a section. The search extends farther and farther from the line until anything beyond makes no
     * difference: most obstacles are small, and a site is large.
     *
     * @param sides the sides on which the paths pass the line
     */
    private DiffractedPath[] found(Line line, Section section, double farthest, double first, boolean... sides) {
        DiffractedPath[] paths = new DiffractedPath[sides.length];
        boolean isFound = false;
        for (double detour = first; !isFound; detour *= FARTHER) {
            double sum = Math.min(farthest, line.length() + detour);
            line.cut(section, section == upright, sum);
            isFound = true;
            for (int side = 0; side < sides.length; side++) {
                if (paths[side] == null) {
                    boolean isAll = sum == farthest;
                    DiffractedPath path = new DiffractedPath(section, sides[side], line.wavelength(), isAll);
                    paths[side] = isAll || path.isSettled(sum) ? path : null;
                    isFound &= paths[side] != null;
                }
            }
        }
        return paths;
    }

    /** The vector of length 1 that is perpendicular to a direction and as upright as possible. */
    private static Position upwards(Position ahead) {
        boolean isSteep = Math.hypot(ahead.x(), ahead.y()) < 1e-6;
        Position up = isSteep ? new Position(0.0, 1.0, 0.0) : new Position(0.0, 0.0, 1.0);
        Position across = up.minus(ahead.times(up.dot(ahead)));
        return across.times(1.0 / across.length());
    }

    /**
     * The obstacle whose edge causes the greatest loss between two positions; empty if no edge is near the line.
     * Parameters as for {@link #obstacleLoss}.
     */
    public Optional<Obstacle> obstacle(Position from, Position to, double frequency) {
        if (!(from.distance(to) > 0.0)) {
            return Optional.empty();
        }
        // All paths are found at once, since a path looks its triangles up in the section that was cut last.
        Line line = Line.of(from, to, LIGHT / frequency);
        int triangle = paths(line, over(from, to), beside(from, to), Double.POSITIVE_INFINITY)
                .main()
                .triangle();
        return triangle < 0 ? Optional.empty() : Optional.of(world.obstacle(triangle));
    }

    /** The site. */
    public World world() {
        return world;
    }
}
