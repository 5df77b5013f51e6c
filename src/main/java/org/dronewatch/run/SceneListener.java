package org.dronewatch.run;

/** A listener to the events of a scene, called on the thread that runs the scene, in the order of simulated time. */
public interface SceneListener {

    /**
     * A run begins: its models are loaded and its sensors created.
     *
     * @param run number and settings of the run
     * @param stage world and drones of the run, which may be kept and queried by any thread
     */
    default void runStarted(RunInfo run, Stage stage) {}

    /** The sensors that are due at this time have taken their looks. */
    default void observed(Frame frame) {}

    /** A run has ended, either at its full duration or early. */
    default void runEnded(RunResult result) {}

    /** A sensor gained or lost detection of a drone. */
    default void detectionChanged(DetectionEvent event) {}
}
