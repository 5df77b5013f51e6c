package org.dronewatch.scenario;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.dronewatch.geo.EarthPlace;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.geo.LocalPlace;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.Places;

/** In what forms, besides numbers, scene files may give positions. */
public final class PlaceForms {
    private PlaceForms() {}

    /**
     * Kinds of settings, with the forms of positions.
     *
     * @param places of the scene; empty when they cannot be known, since the site's own settings are wrong
     */
    public static Kinds in(Kinds kinds, Supplier<Optional<Places>> places) {
        return kinds.with(Position.class, EarthPlace.class, found(places, Places::at))
                .with(Position.class, LocalPlace.class, found(places, Places::at))
                .with(GroundPoint.class, EarthPoint.class, found(places, Places::at));
    }

    /** These forms, for who only wants to know what they look like. */
    public static Kinds in(Kinds kinds) {
        return in(kinds, Optional::empty);
    }

    private static <F, T> Function<F, Optional<T>> found(Supplier<Optional<Places>> places, At<F, T> at) {
        return written -> places.get().map(known -> at.of(known, written));
    }

    /** One of the methods of {@link Places}. */
    private interface At<F, T> {
        T of(Places places, F written);
    }
}
