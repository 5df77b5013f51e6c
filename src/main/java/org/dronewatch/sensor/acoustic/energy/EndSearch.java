package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.energy.ScatterSamples.Sample;
import org.dronewatch.sensor.acoustic.energy.ScatterSamples.Samples;
import org.dronewatch.sensor.acoustic.imagesource.ImageSourceCandidates;
import org.dronewatch.sensor.acoustic.imagesource.ImageSourceSearch;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.imagesource.SpecularPath;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * Finds the image sources that matter between a sensor and a source. Rays from either end find them, and purely
 * specular paths are constructed from them. In the open, where few rays pass an end, image sources are also kept whose
 * reflections carry most of the sound that is scattered near one end to the other. For use by one thread.
 */
final class EndSearch {
    /**
     * Number of rays from either end that find its image sources: the same from both ends, so that together they find
     * the same when the ends are exchanged.
     */
    private static final int RAYS = 2000;

    /** The number of rays if one end is sheltered: sound that comes in through a door comes from few image sources. */
    private static final int RAYS_TO_SHELTER = 4000;

    /**
     * Image sources are chosen as for this number of rays at most: with more rays, fewer image sources would be worth
     * joining, and the sound that comes from the others through a door is too faint in the wide spheres in which
     * passing rays are counted.
     */
    private static final int MOST_RAYS = 8000;

    /** Maximum number of image sources for which purely specular paths are searched. */
    private static final int MOST_PURE = 8000;

    /** Maximum number of those image sources that rays find after they have passed through walls. */
    private static final int MOST_BEHIND_WALLS = 2000;

    /** Maximum number of walls of each end that are tried as additional reflections of exact paths. */
    private static final int MOST_EXTRA = 6;

    /** Maximum number of image sources from which those that join scattered sound to an end are chosen. */
    private static final int MOST_CANDIDATES = 200;

    /**
     * If less than this fraction of rays leaves the site by way of the first surfaces that they hit, the space counts
     * as enclosed.
     */
    private static final double OPEN = 0.1;

    /** If less than this fraction of them does, as in a courtyard, the space counts as sheltered. */
    private static final double SHELTERED = 0.8;

    /**
     * In an enclosed space, roulette begins below this fraction of the energy that the first few surfaces leave: rays
     * in rooms that absorb much have to be followed to fainter energies, at little cost.
     */
    private static final double FAINT = 0.5;

    private static final int SAMPLES = 64;
    private static final int SAMPLES_OF_SHELTER = 256;
    private static final int SCATTERINGS = 3;

    private final int maxOrder;
    private final double roulette;
    private final Position sensor;
    private final WallPlanes planes;
    private final ImageSourceSearch search;
    private final ScatterSamples samples;
    private final JoinedImages joined;
    private final RoughEstimate rough;
    private final WorthwhileImages worthwhile;
    private final Samples samplesOfSensor;

    /**
     * The sensor as an end, by whether one end is sheltered and by the fraction of direct sound that passes through
     * walls; found when it is first needed.
     */
    private final Map<Boolean, Map<Double, End>> ofSensor = Map.of(true, new HashMap<>(), false, new HashMap<>());

    EndSearch(
            EnergyModel model, Position sensor, double radius, World world, WallPlanes planes, BandSurfaces surfaces) {
        this.maxOrder = model.imageSourceOrder();
        this.roulette = model.roulette();
        double ofOneRay = 1.0 / (Math.min(model.rays(), MOST_RAYS) * Math.PI * radius * radius);
        this.sensor = sensor;
        this.planes = planes;
        this.search = new ImageSourceSearch(world, planes, surfaces);
        this.samples = new ScatterSamples(world, planes, surfaces);
        this.joined = new JoinedImages(planes, new SpecularPath(world, planes, surfaces), ofOneRay);
        this.worthwhile = new WorthwhileImages(world, planes, surfaces, ofOneRay);
        this.rough = new RoughEstimate(world, planes, surfaces);
        this.samplesOfSensor = samples.from(sensor, SAMPLES, SCATTERINGS);
    }

    /**
     * One end of the paths.
     *
     * @param position position of the end, m
     * @param found its image sources
     * @param rays number of rays that found them
     * @param pure image sources from which purely specular paths are constructed
     * @param candidates the best image sources
     * @param samples the points at which rays from it are scattered
     */
    private record End(
            Position position,
            ImageSourceCandidates found,
            int rays,
            ImageSources pure,
            ImageSources candidates,
            Samples samples) {}

    private End end(Position position, int rays, Samples itsSamples, double direct) {
        ImageSourceCandidates behindWalls = new ImageSourceCandidates();
        ImageSourceCandidates found = search.from(position, rays, maxOrder, behindWalls, direct);
        ImageSources pure = found.best(MOST_PURE, 0.0);
        if (!behindWalls.isEmpty()) {
            ImageSourceCandidates both = new ImageSourceCandidates();
            both.add(pure);
            both.add(behindWalls.best(MOST_BEHIND_WALLS, 0.0));
            pure = both.best(Integer.MAX_VALUE, 0.0);
        }
        return new End(position, found, rays, pure, found.best(MOST_CANDIDATES, 0.0), itsSamples);
    }

    private End sensor(boolean isToShelter, double direct) {
        return ofSensor.get(isToShelter)
                .computeIfAbsent(
                        direct, key -> end(sensor, isToShelter ? RAYS_TO_SHELTER : RAYS, samplesOfSensor, key));
    }

    /**
     * Finds the image sources of one look, and with them the exact paths.
     *
     * @param curvature curvature of the paths of sound
     */
    Ends find(SoundSource source, ExactPaths exact, PathCurvature curvature) {
        Position drone = source.position();
        Samples samplesOfSource = samples.from(drone, SAMPLES, SCATTERINGS);
        double escapedOfSensor = samplesOfSensor.escaped();
        double escapedOfSource = samplesOfSource.escaped();
        double guess = rough.straight(drone, sensor)
                + (rough.scattered(drone, samplesOfSensor) + rough.scattered(sensor, samplesOfSource)) / 2.0;
        boolean isToShelter = Math.min(escapedOfSource, escapedOfSensor) < SHELTERED;
        double direct = rough.through(drone, sensor);
        End fromHere = sensor(isToShelter, direct);
        ImageSources fromSensor = worthwhile.among(fromHere.pure(), sensor, drone, guess);
        if (escapedOfSource <= OPEN && escapedOfSensor <= OPEN) {
            int[] first = firstWalls(fromHere).toArray();
            exact.find(source, sensor, fromSensor, ImageSources.NONE, first, new int[0], curvature);
            return enclosed(source, fromSensor, exact, guess, curvature, samplesOfSource);
        }
        End fromThere = end(drone, fromHere.rays(), samplesOfSource, direct);
        ImageSources fromSource = worthwhile.among(fromThere.pure(), drone, sensor, guess);
        int[] extra = IntStream.concat(firstWalls(fromHere), firstWalls(fromThere))
                .distinct()
                .toArray();
        exact.find(source, sensor, fromSensor, fromSource, extra, extra, curvature);
        return escapedOfSource < Math.min(SHELTERED, escapedOfSensor)
                ? between(source, true, fromThere, fromSource, fromHere, fromSensor, exact, curvature)
                : between(source, false, fromHere, fromSensor, fromThere, fromSource, exact, curvature);
    }

    private static IntStream firstWalls(End end) {
        return Arrays.stream(end.found().firstWalls(MOST_EXTRA));
    }

    /**
     * Finds those exact paths of one look to which the image sources of the sensor lead; these image sources are the
     * same for all looks.
     *
     * @param curvature curvature of the paths of sound
     */
    void findWithoutSource(SoundSource source, ExactPaths exact, PathCurvature curvature) {
        Position drone = source.position();
        double guess = rough.scattered(drone, samplesOfSensor) + rough.straight(drone, sensor);
        End fromHere = sensor(true, rough.through(drone, sensor));
        ImageSources fromSensor = worthwhile.among(fromHere.pure(), sensor, drone, guess);
        int[] extra = firstWalls(fromHere).toArray();
        exact.find(source, sensor, fromSensor, ImageSources.NONE, extra, extra, curvature);
    }

    /**
     * The ends in an enclosed space. If only strong rays survived there, a few that happen to pass the source would
     * decide what is heard.
     */
    private Ends enclosed(
            SoundSource source,
            ImageSources fromSensor,
            ExactPaths exact,
            double known,
            PathCurvature curvature,
            Samples samplesOfSource) {
        return new Ends(
                source,
                sensor,
                false,
                ImageSources.NONE,
                ImageSources.NONE,
                ImageSources.NONE,
                fromSensor,
                imageSources(exact.wallSequences()),
                known,
                curvature,
                false,
                exact.isThroughWalls(),
                Math.min(roulette, FAINT * (samplesOfSensor.left() + samplesOfSource.left()) / 2.0),
                scatterers(samplesOfSensor, samplesOfSource));
    }

    private Ends between(
            SoundSource source,
            boolean isFromSource,
            End start,
            ImageSources pureOfStart,
            End target,
            ImageSources pureOfTarget,
            ExactPaths exact,
            PathCurvature curvature) {
        List<int[]> exactly = isFromSource
                ? exact.wallSequences().stream().map(SpecularPaths::reversed).toList()
                : exact.wallSequences();
        ImageSourceCandidates near = new ImageSourceCandidates();
        ImageSourceCandidates far = new ImageSourceCandidates();
        // Sound that walls reflect from one end to the other returns by way of the same walls in reverse order.
        addAll(target.candidates(), near, far);
        addAll(start.candidates(), far, near);
        if (start.samples().escaped() < SHELTERED) {
            List<Position> shelter = samples.from(start.position(), SAMPLES_OF_SHELTER, SCATTERINGS).points().stream()
                    .map(Sample::at)
                    .toList();
            addAll(search.towards(target.position(), shelter, maxOrder).best(MOST_CANDIDATES, 0.0), near, far);
        }
        for (int[] walls : exactly) {
            near.add(walls, 0.0);
            far.add(SpecularPaths.reversed(walls), 0.0);
        }
        double known = rough.scattered(target.position(), start.samples());
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            known += exact.heard(band);
        }
        Samples firstScattered = samples.from(target.position(), SAMPLES, 1);
        double first = rough.scattered(start.position(), firstScattered) / target.rays();
        ImageSources ofTarget = joined.of(
                near,
                target.position(),
                start.samples(),
                known,
                walls -> first * target.found().worth(walls));
        ImageSources ofStart = joined.of(far, start.position(), firstScattered, known, walls -> 0.0);
        return new Ends(
                source,
                sensor,
                isFromSource,
                ofTarget,
                ofStart,
                pureOfTarget,
                pureOfStart,
                imageSources(exactly),
                known,
                curvature,
                true,
                exact.isThroughWalls(),
                roulette,
                scatterers(start.samples(), target.samples()));
    }

    private static ImageSources imageSources(List<int[]> sequences) {
        ImageSourceCandidates all = new ImageSourceCandidates();
        sequences.forEach(walls -> all.add(walls, 0.0));
        return all.best(Integer.MAX_VALUE, 0.0);
    }

    private static Set<Integer> scatterers(Samples one, Samples other) {
        Set<Integer> scatterers = new TreeSet<>(one.materials());
        scatterers.addAll(other.materials());
        return scatterers;
    }

    private static void addAll(ImageSources imageSources, ImageSourceCandidates same, ImageSourceCandidates reverse) {
        for (int image = 1; image < imageSources.count(); image++) {
            same.add(imageSources.walls(image), 0.0);
            reverse.add(SpecularPaths.reversed(imageSources.walls(image)), 0.0);
        }
    }
}
