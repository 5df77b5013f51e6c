package org.dronewatch.scene;

import java.util.function.Supplier;
import org.dronewatch.setting.InputException;

/**
 * The pilots of the runs of a scene. If one cannot be made, that is a mistake of its author, which is reported in one
 * line.
 *
 * @param source returns a new pilot for each run
 */
record Pilots(Supplier<Pilot> source) implements Supplier<Pilot> {

    /**
     * The pilot of the next run.
     *
     * @throws InputException when there is none
     */
    @Override
    public Pilot get() {
        Pilot pilot;
        try {
            pilot = source.get();
        } catch (InputException e) {
            throw e;
        } catch (RuntimeException | LinkageError e) {
            throw new PilotFault(source.getClass(), e).beforeTheRun();
        }
        if (pilot == null) {
            throw new InputException("the scene's pilot is missing: a pilot may be Pilot.NONE, but not null");
        }
        return pilot;
    }
}
