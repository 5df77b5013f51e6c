package org.dronewatch.scene;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.dronewatch.run.Frame;
import org.dronewatch.run.LookTimes;
import org.dronewatch.run.ModelCache;
import org.dronewatch.run.Pace;
import org.dronewatch.run.RunInfo;

/**
 * What a scene needs to know for one run.
 *
 * @param info number and settings of the run
 * @param models where models come from
 * @param frames is given each frame
 * @param pace keeps time
 * @param times is told how long sensors looked
 * @param cancelled says when to stop early
 */
record RunPlan(
        RunInfo info,
        ModelCache models,
        Consumer<Frame> frames,
        Pace pace,
        LookTimes times,
        BooleanSupplier cancelled) {}
