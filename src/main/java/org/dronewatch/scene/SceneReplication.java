package org.dronewatch.scene;

import nl.tudelft.simulation.dsol.experiment.Replication;
import nl.tudelft.simulation.naming.context.JvmContext;

/**
 * A replication with a naming context of its own: DSOL's shared root context is neither safe for threads nor ever
 * cleared.
 */
final class SceneReplication extends Replication<Double> {
    private static final long serialVersionUID = 1L;

    SceneReplication(String id, double duration) {
        super(id, 0.0, 0.0, duration);
        setContext(new JvmContext(id));
    }
}
