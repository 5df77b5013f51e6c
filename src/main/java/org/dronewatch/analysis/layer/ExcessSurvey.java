package org.dronewatch.analysis.layer;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.InterpolableSensor;
import org.dronewatch.sensor.Signal;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Chooses the positions at which a sensor's signal levels are traced: first some at random, in the cells of a field and
 * between the heights of these cells; then, in two rounds, more where neighbours differ and the level is near the
 * threshold. Further random positions are held out to measure the error. All random numbers come from one stream, which
 * depends only on the seed and on the names of sensor and drone.
 */
public final class ExcessSurvey {
    /** The greatest numbers of positions: outdoors, and indoors, where tracing takes longer. */
    static final int MOST = 5000;

    static final int MOST_INDOORS = 500;
    private static final double HELD_OUT = 0.1;
    private static final int ROUNDS = 2;

    /** Candidates for each position of a round. */
    private static final int CANDIDATES = 4;

    /** Draws for each position before the cells count as used up. */
    private static final int MOST_DRAWS = 50;

    /** Within about this margin it matters how accurate a level is, dB. */
    private static final double NEAR = 3.0;

    /**
     * The number of directions in which the sky is looked for, and the greatest fraction of them that is free indoors.
     */
    private static final int DIRECTIONS = 64;

    private static final double INDOORS = 0.1;

    private final FieldProbe probe;
    private final FieldColumns columns;
    private final SurveyProgress progress;
    private final RandomGenerator random;
    private final Set<Position> taken = new HashSet<>();

    private ExcessSurvey(FieldProbe probe, FieldColumns columns, SurveyProgress progress) {
        this.probe = probe;
        this.columns = columns;
        this.progress = progress;
        this.random = Draws.stream(probe.seed(), probe.sensor(), probe.drone().id(), 0, "survey");
    }

    /**
     * A map for a sensor that can be interpolated, on the {@link Workers} of the calling thread; empty for others, and
     * where there are too few cells for it.
     */
    static Optional<ExcessMap> of(FieldProbe probe, FieldColumns columns, SurveyProgress progress) {
        return of(probe, columns, most(probe), progress);
    }

    private static int most(FieldProbe probe) {
        return isIndoors(probe.world(), probe.settings().position()) ? MOST_INDOORS : MOST;
    }

    /** Whether a sensor's signal may be interpolated. */
    public static boolean isPossible(FieldProbe probe) {
        return probe.newAssessor()
                .interpolable()
                .flatMap(sensor -> sensor.signalInTheOpen(probe.world(), probe.drone()))
                .isPresent();
    }

    /** Whether there is a map of a sensor. */
    static boolean isWorthwhile(FieldProbe probe, FieldColumns columns) {
        return isWorthwhile(probe, columns, most(probe));
    }

    private static boolean isWorthwhile(FieldProbe probe, FieldColumns columns, int most) {
        return isPossible(probe) && columns.openCount() > most;
    }

    /** The same with at most this number of positions. */
    static Optional<ExcessMap> of(FieldProbe probe, FieldColumns columns, int most, SurveyProgress progress) {
        return isWorthwhile(probe, columns, most)
                ? Optional.of(new ExcessSurvey(probe, columns, progress).map(most))
                : Optional.empty();
    }

    private ExcessMap map(int most) {
        List<TracedPlace> heldOut = trace(positions((int) (HELD_OUT * most)), true, most);
        int inRound = (most - heldOut.size()) / (ROUNDS + 1);
        List<TracedPlace> places = new ArrayList<>(trace(positions(inRound), false, most));
        for (int round = 0; round < ROUNDS; round++) {
            places.addAll(trace(worthwhile(new ExcessMap(places, List.of()), inRound), false, most));
        }
        return new ExcessMap(places, heldOut);
    }

    /**
     * Traces positions on a random course each, or on the first one. Not on courses across the line of sight of other
     * sensors: what is interpolated for this one is the same with and without them.
     *
     * @param of the number of all positions of the survey
     */
    private List<TracedPlace> trace(List<Position> positions, boolean isOnAnyCourse, int of) {
        int[] own = probe.ownCourses();
        int[] courses = positions.stream()
                .mapToInt(at -> isOnAnyCourse ? own[random.nextInt(own.length)] : 0)
                .toArray();
        TracedPlace[] traced = new TracedPlace[positions.size()];
        Workers.forEach(traced.length, probe::newAssessor, (assessor, i) -> {
            traced[i] = TracedPlace.of(probe, assessor, probe.drone(positions.get(i), courses[i]));
            progress.traced(of);
        });
        return List.of(traced);
    }

    /** This many positions; fewer where hardly any are left, as above a large roof, below which there are none. */
    private List<Position> positions(int count) {
        List<Position> positions = new ArrayList<>();
        for (int draws = 0; positions.size() < count && draws < MOST_DRAWS * count; draws++) {
            Position at = position();
            if (taken.add(at)) {
                positions.add(at);
            }
        }
        return positions;
    }

    /** The centre of a cell, or a point somewhere between that and the next one below. */
    private Position position() {
        int level;
        int column;
        int row;
        do {
            level = random.nextInt(columns.levels());
            column = random.nextInt(columns.columns());
            row = random.nextInt(columns.rows());
        } while (!columns.isOpen(level, column, row));
        double down = random.nextBoolean() ? random.nextDouble() : 0.0;
        Position top = columns.middle(level, column, row);
        if (level > 0 && !columns.isOpen(level - 1, column, row)) {
            return top;
        }
        double bottom = level == 0
                ? columns.ground(column, row)
                : columns.middle(level - 1, column, row).z();
        return new Position(top.x(), top.y(), top.z() - down * (top.z() - bottom));
    }

    /**
     * Candidates drawn without replacement with probabilities in proportion to their worth (Efraimidis and Spirakis
     * 2006).
     */
    private List<Position> worthwhile(ExcessMap map, int count) {
        List<Position> candidates = positions(CANDIDATES * count);
        double[] keys = random.doubles(candidates.size()).toArray();
        Workers.forEach(keys.length, probe::newAssessor, (assessor, i) -> {
            keys[i] = Math.log(keys[i]) / worth(map, assessor, candidates.get(i));
        });
        int[] chosen = IntStream.range(0, keys.length)
                .boxed()
                .sorted(Comparator.comparingDouble(i -> -keys[i]))
                .mapToInt(Integer::intValue)
                .limit(count)
                .toArray();
        Arrays.sort(chosen);
        List<Position> best = Arrays.stream(chosen).mapToObj(candidates::get).toList();
        taken.removeAll(candidates);
        taken.addAll(best);
        return best;
    }

    private double worth(ExcessMap map, Assessor assessor, Position at) {
        Drone there = probe.drone(at, 0);
        InterpolableSensor sensor = assessor.interpolable().orElseThrow();
        Signal open = sensor.signalInTheOpen(probe.world(), there).orElseThrow();
        Optional<ExcessMap.Estimate> estimate = map.at(at, sensor.isInSight(probe.world(), there));
        if (estimate.isEmpty()) {
            return 1.0;
        }
        double margin = open.quantity() + estimate.get().overOpen() - open.threshold();
        double spread = 0.01 + 0.5 * (estimate.get().greatest() - estimate.get().least());
        return spread
                / (1.0
                        + Math.abs(margin)
                                / (NEAR
                                        + estimate.get().greatest()
                                        - estimate.get().least()));
    }

    /** Whether something is above a sensor in nearly all directions. */
    static boolean isIndoors(World world, Position at) {
        Visibility visibility = new Visibility(world);
        int free = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            // Evenly over the upper hemisphere: a spiral with the golden angle.
            double up = (i + 0.5) / DIRECTIONS;
            double across = Math.sqrt(1.0 - up * up);
            double angle = i * Math.PI * (3.0 - Math.sqrt(5.0));
            double east = across * StrictMath.cos(angle);
            double north = across * StrictMath.sin(angle);
            free += visibility.isFreeAlong(at.x(), at.y(), at.z(), east, north, up, Double.POSITIVE_INFINITY) ? 1 : 0;
        }
        return free <= INDOORS * DIRECTIONS;
    }
}
