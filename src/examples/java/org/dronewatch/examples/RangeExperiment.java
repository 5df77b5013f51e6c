package org.dronewatch.examples;

import java.util.concurrent.CountDownLatch;
import java.util.function.Function;
import nl.tudelft.simulation.dsol.experiment.Experiment;
import nl.tudelft.simulation.dsol.experiment.Replication;
import nl.tudelft.simulation.dsol.simulators.DevsSimulator;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import org.djutils.stats.summarizers.Tally;
import org.dronewatch.scene.Scene;
import org.dronewatch.sensor.Observation;

/** A DSOL experiment: a scene in many replications, each with its own seed, and a tally over all of them. */
public final class RangeExperiment {
    private final String sensor;
    private final String drone;
    private final Tally ranges = new Tally("range of first detection [m]");
    private Replication<Double> counted;

    /** An experiment about one sensor and one drone. */
    public RangeExperiment(String sensor, String drone) {
        this.sensor = sensor;
        this.drone = drone;
    }

    /** The ranges at which the sensor first detects the drone, one for each replication in which it does, m. */
    public Tally run(Function<DevsSimulatorInterface<Double>, Scene> site, double duration, int replications)
            throws InterruptedException {
        DevsSimulator<Double> simulator = new DevsSimulator<>("ranges");
        Scene scene = site.apply(simulator);
        scene.addListener(
                event -> look((Observation) event.getContent(), simulator.getReplication()), Scene.OBSERVATION);
        Experiment<Double, DevsSimulatorInterface<Double>> experiment =
                new Experiment<>("ranges", simulator, scene, 0.0, 0.0, duration, replications);
        CountDownLatch ended = new CountDownLatch(1);
        experiment.addListener(event -> ended.countDown(), Experiment.END_EXPERIMENT_EVENT);
        try {
            experiment.start();
            ended.await();
        } finally {
            simulator.cleanUp();
        }
        return ranges;
    }

    private void look(Observation seen, Replication<Double> replication) {
        boolean isOfPair = seen.sensor().equals(sensor) && seen.drone().equals(drone);
        if (isOfPair && seen.isDetected() && !replication.equals(counted)) {
            counted = replication;
            ranges.register(seen.range());
        }
    }
}
