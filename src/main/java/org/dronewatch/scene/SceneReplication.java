package org.dronewatch.scene;

import nl.tudelft.simulation.dsol.experiment.Replication;
import nl.tudelft.simulation.naming.context.JvmContext;

/** A replication with a separate naming context: DSOL's shared root context is neither thread-safe nor ever cleared. */
final class SceneReplication extends Replication<Double> {
    private static final long serialVersionUID = 1L;

    SceneReplication(String id, double duration) {
        // DSOL refuses a run without length; one that ends at once still has its first looks.
        super(id, 0.0, 0.0, Math.max(duration, Double.MIN_VALUE));
        setContext(new JvmContext(id));
    }
}
