package org.dronewatch.tracking;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.IntSupplier;

/**
 * One sensor's false measurements that may still be confirmed: those in the same cell of its field of view are one
 * contact, until a number of its looks in a row have measured nothing there.
 */
final class LiveAlarms {
    private final int patience;
    private final Map<Double, Live> byCell = new LinkedHashMap<>();

    /**
     * The alarms of one sensor, without any false measurements yet.
     *
     * @param patience number of looks without a measurement after which a contact ends, 1 or more
     */
    LiveAlarms(int patience) {
        this.patience = patience;
    }

    /** The contact to which a measurement belongs; a new one if there is none in its cell. */
    int contactIn(double cell, IntSupplier next) {
        Live live = byCell.computeIfAbsent(cell, unseen -> new Live(next.getAsInt()));
        live.isSeen = true;
        return live.contact;
    }

    /**
     * Ends a look of the sensor.
     *
     * @param missed receives the looks at contacts of which the sensor measured nothing
     * @param ended receives the contacts of which there will be no more looks
     */
    void endLook(String sensor, double time, Consumer<ContactLook> missed, IntConsumer ended) {
        for (Iterator<Live> all = byCell.values().iterator(); all.hasNext(); ) {
            Live live = all.next();
            live.misses = live.isSeen ? 0 : live.misses + 1;
            if (live.misses >= patience) {
                all.remove();
                ended.accept(live.contact);
            } else if (!live.isSeen) {
                missed.accept(new ContactLook(live.contact, sensor, time, List.of()));
            }
            live.isSeen = false;
        }
    }

    private static final class Live {
        private final int contact;
        private boolean isSeen;
        private int misses;

        Live(int contact) {
            this.contact = contact;
        }
    }
}
