package org.dronewatch.sensor.acoustic.energy;

import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.imagesource.SingleReflections;
import org.dronewatch.sensor.acoustic.imagesource.SpecularPath;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Clearance;
import org.dronewatch.world.World;

/**
 * Exact paths of specular reflections alone: one for every wall, and those of the image sources of higher order that
 * rays from the sensor or from the source have found. For use by one thread.
 */
final class SpecularPaths {
    private static final int BANDS = OctaveBands.COUNT;

    /** Images nearer to each other than this multiple of the planes' tolerance count as one. */
    private static final double ALIKE = 100.0;

    /** Once this many paths are known, no more neighbours are searched for. */
    private static final int MOST_NEIGHBOURS = 64;

    /**
     * Ends are kept off surfaces by this multiple of the planes' tolerance. Nearer to a surface, rounding of the walls
     * decides whether a long path runs along the surface or hits it.
     */
    private static final double OFF = 30.0;

    /** The greatest distance by which ends are kept off surfaces, m. */
    private static final double MOST_OFF = 0.05;

    /** A wall is beside an end no farther from its plane than this, m. */
    private static final double BESIDE = 2.0;

    private final WallPlanes planes;
    private final Air air;
    private final GroundReflection ground;
    private final Clearance clearance;
    private final SpecularPath path;
    private final SingleReflections reflections;
    private final double[] heard = new double[BANDS];
    private SoundSource source;
    private Position sensor;

    /** The source and the sensor, kept off surfaces. */
    private Position fromSource;

    private Position fromSensor;
    private PathCurvature curvature = PathCurvature.NONE;

    /** The walls of paths that one wall reflects. */
    private final List<int[]> singles = new ArrayList<>();

    /** The walls of paths that several walls reflect, in order from the source on. */
    private final List<int[]> found = new ArrayList<>();

    /** The same walls as a set: in a room there are hundreds of paths, and thousands of candidates for more. */
    private final Set<IntBuffer> foundWalls = new HashSet<>();

    private double[] imagePositions = new double[0];
    private double[] images = new double[3 * 16];

    SpecularPaths(World world, WallPlanes planes, BandSurfaces surfaces, Air air, GroundReflection ground) {
        this.planes = planes;
        this.air = air;
        this.ground = ground;
        this.clearance = new Clearance(world);
        this.path = new SpecularPath(world, planes, surfaces);
        path.throughWalls(true);
        this.reflections = new SingleReflections(planes);
    }

    /**
     * Begins a look.
     *
     * @param ofAir curvature that the air gives to the paths
     */
    void begin(SoundSource from, Position to, PathCurvature ofAir) {
        double off = Math.min(MOST_OFF, OFF * planes.tolerance());
        source = from;
        sensor = to;
        fromSource = clearance.apart(from.position(), off);
        fromSensor = clearance.apart(to, off);
        curvature = ofAir;
        found.clear();
        foundWalls.clear();
        singles.clear();
    }

    /**
     * Adds all paths that are found from image sources.
     *
     * @param ofSensor image sources of the sensor
     * @param ofSource image sources of the source
     */
    void addTo(FoundPaths paths, ImageSources ofSensor, ImageSources ofSource) {
        path.bend(curvature, true);
        addSingle(paths);
        imagesOf(fromSensor, ofSensor);
        for (int image = 1; image < ofSensor.count(); image++) {
            if (ofSensor.order(image) > 1 && isPath(ofSensor, image, fromSource)) {
                addIfNew(paths, reversed(ofSensor.walls(image)), 1.0);
            }
        }
        path.bend(curvature, false);
        imagesOf(fromSource, ofSource);
        for (int image = 1; image < ofSource.count(); image++) {
            if (ofSource.order(image) > 1
                    && !ofSensor.contains(ofSource.order(image), ofSource.keyOfReverse(image))
                    && isPath(ofSource, image, fromSensor)) {
                addIfNew(paths, ofSource.walls(image), -1.0);
            }
        }
    }

    private void addSingle(FoundPaths paths) {
        Position drone = source.position();
        reflections.find(drone.x(), drone.y(), drone.z(), sensor.x(), sensor.y(), sensor.z());
        for (int i = 0; i < reflections.count(); i++) {
            ImageSources single = ImageSources.of(reflections.wall(i));
            imagesOf(sensor, single);
            if (isPath(single, 1, drone)) {
                FoundPaths itsPlace = ground.among(paths, path.metFirst(0), path.metFirst(1), path.metFirst(2));
                add(itsPlace, path.length(), path.riseFromBeginning());
                singles.add(new int[] {reflections.wall(i)});
            }
        }
    }

    private boolean isPath(ImageSources imageSources, int image, Position from) {
        return path.follow(imageSources, imagePositions, image, from.x(), from.y(), from.z());
    }

    /**
     * Adds paths that a wall beside both ends reflects, in addition to other walls. Rays from either end hit that wall
     * first, unless they run along it, and so miss these paths, which carry as much sound as those that run along it.
     *
     * @param first walls that rays from the ends hit first: those beside both ends are among them
     * @param maxOrder maximum number of walls of a path
     */
    void addAlong(FoundPaths paths, int[] first, int maxOrder) {
        int[] beside = Arrays.stream(first)
                .filter(wall -> isBeside(wall, source.position()) && isBeside(wall, sensor))
                .toArray();
        List<int[]> known = new ArrayList<>(singles);
        known.addAll(found);
        for (int[] walls : known) {
            for (int place = 0; place <= walls.length && walls.length < maxOrder; place++) {
                for (int wall : beside) {
                    addOver(with(walls, place, wall), paths);
                }
            }
        }
    }

    private boolean isBeside(int wall, Position end) {
        return Math.abs(planes.height(wall, end.x(), end.y(), end.z())) < BESIDE;
    }

    /**
     * Adds paths that have one wall more than those added last, or one less: near a wall, a path that also hits that
     * wall lies in so narrow a range of directions that rays may miss it.
     *
     * @param extra the walls that may be added
     * @param maxOrder maximum number of walls of a path
     */
    void addNeighbours(FoundPaths paths, int[] extra, int maxOrder) {
        for (int i = 0; i < found.size() && found.size() < MOST_NEIGHBOURS; i++) {
            int[] walls = found.get(i);
            for (int place = 0; place < walls.length && walls.length > 2; place++) {
                addOver(without(walls, place), paths);
            }
            for (int place = 0; place <= walls.length && walls.length < maxOrder; place++) {
                for (int wall : extra) {
                    addOver(with(walls, place, wall), paths);
                }
            }
        }
    }

    private void addOver(int[] walls, FoundPaths paths) {
        if (isTwiceInTurn(walls) || foundWalls.contains(IntBuffer.wrap(walls))) {
            return;
        }
        ImageSources imageSources = ImageSources.of(walls);
        imagesOf(fromSource, imageSources);
        if (isPath(imageSources, walls.length, fromSensor)) {
            addIfNew(paths, walls, -1.0);
        }
    }

    private static boolean isTwiceInTurn(int[] walls) {
        return IntStream.range(1, walls.length).anyMatch(i -> walls[i] == walls[i - 1]);
    }

    private static int[] with(int[] walls, int place, int wall) {
        int[] more = Arrays.copyOf(walls, walls.length + 1);
        System.arraycopy(walls, place, more, place + 1, walls.length - place);
        more[place] = wall;
        return more;
    }

    private static int[] without(int[] walls, int place) {
        int[] less = Arrays.copyOf(walls, walls.length - 1);
        System.arraycopy(walls, place + 1, less, place, less.length - place);
        return less;
    }

    /** The walls of all paths added last that several walls reflect, in order from the source on. */
    List<int[]> found() {
        return List.copyOf(found);
    }

    /** A sequence of walls in reverse order. */
    static int[] reversed(int[] walls) {
        return IntStream.range(0, walls.length)
                .map(i -> walls[walls.length - 1 - i])
                .toArray();
    }

    private void imagesOf(Position point, ImageSources imageSources) {
        if (imagePositions.length < 3 * imageSources.count()) {
            imagePositions = new double[3 * imageSources.count()];
        }
        imageSources.positions(point.x(), point.y(), point.z(), planes, imagePositions);
    }

    /**
     * Adds the last path unless it is known: at the edge of two perpendicular walls, both orders of the walls give the
     * same path.
     *
     * @param walls the walls, in order from the source on
     * @param side positive if the path was followed from the source, negative if it was followed from the sensor
     */
    private void addIfNew(FoundPaths paths, int[] walls, double side) {
        double x = path.length() * path.leaving(side, 0);
        double y = path.length() * path.leaving(side, 1);
        double z = path.length() * path.leaving(side, 2);
        for (int i = 0; i < found.size(); i++) {
            double away =
                    Math.abs(images[3 * i] - x) + Math.abs(images[3 * i + 1] - y) + Math.abs(images[3 * i + 2] - z);
            if (away < ALIKE * planes.tolerance() && isPermutation(found.get(i), walls)) {
                return;
            }
        }
        if (3 * found.size() == images.length) {
            images = Arrays.copyOf(images, 2 * images.length);
        }
        images[3 * found.size()] = x;
        images[3 * found.size() + 1] = y;
        images[3 * found.size() + 2] = z;
        found.add(walls);
        foundWalls.add(IntBuffer.wrap(walls));
        add(paths, lengthOver(walls), side > 0.0 ? path.riseFromBeginning() : path.riseFromEnd());
    }

    /**
     * The length of a path by way of given walls between the source and the sensor themselves, which are not kept off
     * surfaces here, m.
     */
    private double lengthOver(int[] walls) {
        Position drone = source.position();
        double[] image = {drone.x(), drone.y(), drone.z()};
        for (int wall : walls) {
            planes.mirror(wall, image, 0, image, 0);
        }
        return sensor.distance(new Position(image[0], image[1], image[2]));
    }

    private static boolean isPermutation(int[] some, int[] others) {
        int[] a = some.clone();
        int[] b = others.clone();
        Arrays.sort(a);
        Arrays.sort(b);
        return Arrays.equals(a, b);
    }

    private void add(FoundPaths paths, double length, double rise) {
        for (int band = 0; band < BANDS; band++) {
            heard[band] = path.reflected(band) * source.spread(air, band, rise, length);
        }
        paths.add(length, heard);
    }
}
