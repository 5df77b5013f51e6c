package org.dronewatch.app.option;

import org.dronewatch.run.store.StorePlace;
import picocli.CommandLine.Model.CommandSpec;

/** Where users may ask that nothing be kept for later commands. */
public interface StoreSwitch {
    /** Where prepared sites are kept. */
    StorePlace store();

    /** Where a command keeps prepared sites: as the user of its main command asks. */
    static StorePlace of(CommandSpec command) {
        return command.root().userObject() instanceof StoreSwitch given ? given.store() : StorePlace.ofProcess();
    }
}
