package org.dronewatch.app.option;

import org.dronewatch.run.store.StorePlace;
import picocli.CommandLine.Model.CommandSpec;

/** A command with a switch that turns off the store of prepared sites. */
public interface StoreSwitch {
    /** Where prepared sites are kept. */
    StorePlace store();

    /**
     * Where a command keeps prepared sites: as set on its main command if that has such a switch, otherwise in the
     * store of this process.
     */
    static StorePlace of(CommandSpec command) {
        return command.root().userObject() instanceof StoreSwitch given ? given.store() : StorePlace.ofProcess();
    }
}
