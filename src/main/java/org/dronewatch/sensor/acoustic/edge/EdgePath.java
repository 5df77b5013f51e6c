package org.dronewatch.sensor.acoustic.edge;

import java.util.Arrays;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.EllipsoidQuery;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;
import org.dronewatch.world.World;

/**
 * The shortest path around the obstacles between two points, over any number of edges: the shortest convex path within
 * any one plane through both points. Several {@linkplain TrialPlanes planes} are tried, or more if no path is found,
 * and the best ones are rotated about the line between the points until the path cannot be shortened. For a single
 * straight edge, this is the globally shortest path; over several, it is the path used by the standards, which treat
 * propagation in separate planes. A path through an opening that none of the planes intersects is not found.
 *
 * <p>Short detours are tried first, in the vertical and the horizontal plane before the others, so that only obstacles
 * near the straight line are examined if that suffices. Exchanging the points gives the same path. For one thread.
 */
public final class EdgePath {
    /** If no plane has a path, planes between them are tried, up to this number. */
    private static final int MOST_PLANES = 48;

    /** The first limit on the detour, m, and the factor by which it grows. */
    private static final double FIRST_DETOUR = 0.5;

    private static final double LONGER = 8.0;

    /**
     * The longest detour of a path in the vertical or the horizontal plane that is used as a bound, m. Most paths lead
     * over a building or around it, and one plane costs a twelfth of what all planes cost. A bound that is much too
     * large makes the other planes slower, but not less accurate.
     */
    private static final double LONGEST_BOUND = 32.0;

    /** Other planes are rotated, too, if their detour is at most this multiple of the shortest. */
    private static final double NEARLY_AS_SHORT = 1.15;

    /** No path is longer than this multiple of the path by way of the farthest point of the world. */
    private static final double TO_AND_FRO = 4.0;

    private static final int TURNS = 11;
    private static final int FIXED = -1;
    private static final EdgeSequence NONE = new EdgeSequence();

    private final World world;
    private final TriangleMesh mesh;
    private final PlaneCut cut;
    private final RubberBand band = new RubberBand();
    private final TrialPlanes planes;
    private final double[] detours = new double[TrialPlanes.MOST];

    private StraightLine line;
    private double straight;
    private double curvature;

    private double pathDifference;
    private double arcDifference;
    private final EdgeSequence shortest = new EdgeSequence();

    /** The shortest paths found by rotating each of the planes, one of which is the shortest of all. */
    private final EdgeSequence[] ofMinima = new EdgeSequence[TrialPlanes.MOST];

    private int minima;
    private int ofShortest;

    /** The index of the minimum about which planes are being rotated; {@value #FIXED} while none is. */
    private int turned = FIXED;

    private double firstRise;
    private double lastRise;

    /** Paths in a world. */
    public EdgePath(World world) {
        this.world = world;
        this.mesh = world.mesh();
        this.cut = new PlaneCut(mesh, new EllipsoidQuery(world.tree()));
        this.planes = new TrialPlanes(world);
        Arrays.setAll(ofMinima, i -> new EdgeSequence());
    }

    /**
     * Searches for the shortest path around the obstacles between two points that are not mutually visible, in still
     * air.
     *
     * @return whether a path was found
     */
    public boolean find(Position source, Position sensor) {
        return find(source, sensor, 0.0);
    }

    /**
     * Searches for the shortest path around the obstacles between two points whose connecting arc of sound is
     * obstructed.
     *
     * @param bending curvature of sound from the source to the sensor: {@link PathCurvature#along}, 1/m
     * @return whether a path was found
     */
    public boolean find(Position source, Position sensor, double bending) {
        curvature = bending;
        line = StraightLine.between(source, sensor);
        straight = line.length();
        pathDifference = Double.POSITIVE_INFINITY;
        if (!(straight > 0.0) || mesh.triangleCount() == 0) {
            return false;
        }
        planes.choose(line);
        boundByMainPlanes();
        if (isFound()) {
            double most = bound(Double.POSITIVE_INFINITY);
            pathDifference = Double.POSITIVE_INFINITY;
            search(most);
            if (isFound()) {
                return true;
            }
        }
        double farthest = line.farthest(world.bounds());
        double detour = FIRST_DETOUR;
        double limit;
        do {
            limit = straight + detour;
            if (limit >= farthest) {
                // A taut string stays within the hull of the world and its ends, but may go to and fro within it.
                limit = TO_AND_FRO * farthest;
            }
            search(limit);
            detour *= LONGER;
        } while (!isFound() && limit < farthest);
        for (int number = 2 * TrialPlanes.EVEN; !isFound() && number <= MOST_PLANES; number *= 2) {
            searchBetween(number, limit);
        }
        return isFound();
    }

    /**
     * The path difference between the last path found and the straight line, 0 or more, m; infinite if no path was
     * found. If sound travels in arcs, this is the difference between their travel times, multiplied by the speed of
     * sound on the straight line.
     */
    public double pathDifference() {
        return pathDifference;
    }

    /**
     * The distance along the straight line to the point halfway between the first and the last edge, or to the middle
     * of the line if there are no edges, m.
     */
    public double halfWay() {
        int edges = shortest.count();
        double middle = edges == 0 ? 0.5 * straight : 0.5 * (shortest.along(0) + shortest.along(edges - 1));
        return line.isExchanged() ? Math.max(0.0, straight - middle) : Math.min(middle, straight);
    }

    /**
     * The path difference between the arcs of the last path found, from edge to edge, and the unobstructed arc from end
     * to end, m. Sound that bends down travels faster at greater heights, so this is then more than
     * {@link #pathDifference}; CNOSSOS-EU uses this difference in that case.
     */
    public double arcDifference() {
        return arcDifference;
    }

    /** The edges of the last path found. */
    public EdgeSequence edges() {
        return shortest;
    }

    /**
     * The number of paths that cannot be shortened and are nearly as short as the shortest, such as the one around the
     * side of a house if the shortest one leads over its roof. The shortest path itself may be among them.
     */
    public int others() {
        return minima;
    }

    /**
     * The edges of one of the paths that {@link #others} counts. For the shortest path, which {@link #edges} gives, the
     * result is a path without edges and with an infinite detour.
     *
     * @param number index of the path, 0 to {@link #others} - 1
     */
    public EdgeSequence other(int number) {
        return number == ofShortest ? NONE : ofMinima[number];
    }

    /** Sine of the elevation at which the path leaves the source; negative downward. */
    public double sinElevation() {
        return line.isExchanged() ? lastRise : firstRise;
    }

    private boolean isFound() {
        return Double.isFinite(pathDifference);
    }

    /** Finds a path in the vertical or the horizontal plane: its length limits the search in all planes. */
    private void boundByMainPlanes() {
        for (double detour = FIRST_DETOUR; !isFound() && detour <= LONGEST_BOUND; detour *= LONGER) {
            for (int i = 0; i < 2; i++) {
                detour(0.5 * i * Math.PI, bound(straight + detour));
            }
        }
    }

    /** Tries all planes, and rotates the best ones. */
    private void search(double limit) {
        int count = planes.count();
        minima = 0;
        ofShortest = FIXED;
        for (int i = 0; i < count; i++) {
            detours[i] = detour(planes.angle(i), bound(limit));
        }
        double best = pathDifference;
        if (!isFound()) {
            return;
        }
        for (int i = 0; i < count; i++) {
            int before = (i + count - 1) % count;
            double here = detours[i];
            if (here <= NEARLY_AS_SHORT * best + 1e-6 && here <= detours[before] && here <= detours[(i + 1) % count]) {
                turned = minima;
                ofMinima[minima++].clear();
                ofShortest = here == best && ofShortest == FIXED ? turned : ofShortest;
                turn(planes.angle(i), planes.step(before), planes.step(i));
                turned = FIXED;
            }
        }
    }

    /** Tries the planes that lie between those tried before. */
    private void searchBetween(int number, double limit) {
        double step = Math.PI / number;
        Arrays.fill(detours, Double.POSITIVE_INFINITY);
        double bestAngle = 0.0;
        for (int i = 1; i < number; i += 2) {
            double before = pathDifference;
            detour(i * step, bound(limit));
            if (pathDifference < before) {
                bestAngle = i * step;
            }
        }
        if (isFound()) {
            turn(bestAngle, step, step);
        }
    }

    /** Rotates a plane by up to a step back or ahead, to the angle at which its path is shortest. */
    private void turn(double angle, double back, double ahead) {
        double limit = bound(Double.POSITIVE_INFINITY);
        GoldenSection.search(at -> detour(at, limit), angle + 0.5 * (ahead - back), 0.5 * (back + ahead), TURNS);
    }

    /** The greatest length of interest, m: once a path is known, planes with a much longer one are not rotated. */
    private double bound(double limit) {
        return isFound() ? Math.min(limit, straight + 1.2 * pathDifference + 1e-3) : limit;
    }

    /** The detour of the shortest path in a plane, m, or infinity; the path is kept if it is the shortest so far. */
    private double detour(double angle, double limit) {
        Position side = line.side(angle);
        cut.cut(line.from(), line.to(), line.ahead(), side, PathCurvature.reach(curvature, straight, limit), curvature);
        if (!band.find(cut.outline(), straight, limit)) {
            return Double.POSITIVE_INFINITY;
        }
        double detour = Math.max(0.0, band.length() - straight);
        if (turned != FIXED && detour < ofMinima[turned].detour()) {
            ofMinima[turned].take(band, straight, detour);
        }
        if (detour < pathDifference) {
            keep(detour, side);
        }
        return detour;
    }

    private void keep(double detour, Position side) {
        pathDifference = detour;
        ofShortest = turned;
        shortest.take(band, straight, detour);
        arcDifference = -PathCurvature.arc(curvature, straight);
        double u = 0.0;
        double v = 0.0;
        double raised = 0.0;
        int edges = shortest.count();
        for (int i = 0; i <= edges; i++) {
            double du = (i < edges ? band.u(i) : straight) - u;
            double dv = (i < edges ? band.v(i) : 0.0) - v;
            double nextRaised = i < edges ? cut.bulgeAt(band.u(i)) : 0.0;
            arcDifference += PathCurvature.arc(curvature, Math.hypot(du, dv - nextRaised + raised));
            raised = nextRaised;
            double rise = (du * line.ahead().z() + dv * side.z()) / Math.hypot(du, dv);
            if (i == 0) {
                firstRise = rise;
            }
            lastRise = -rise;
            u += du;
            v += dv;
        }
    }
}
