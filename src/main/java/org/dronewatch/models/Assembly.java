package org.dronewatch.models;

import java.util.ArrayList;
import java.util.List;

/** The named parts of a craft, laid out roughly and then stretched to its stated size, so that the size is exact. */
final class Assembly {
    private static final int DECIMALS = 5;

    private final List<String> names = new ArrayList<>();
    private final List<Solid> solids = new ArrayList<>();

    void add(String name, Solid solid) {
        names.add(name);
        solids.add(solid);
    }

    /** Stretches each axis so that the whole has a size, metres, about the origin. */
    Mesh fitted(String name, Point wanted) {
        Extent rough = extent();
        Point size = rough.size();
        Point middle = rough.min().towards(rough.max(), 0.5);
        Point stretch = new Point(wanted.x() / size.x(), wanted.y() / size.y(), wanted.z() / size.z());
        MeshBuilder builder = new MeshBuilder(name, DECIMALS);
        for (int i = 0; i < solids.size(); i++) {
            builder.add(names.get(i), solids.get(i).moved(p -> {
                Point q = p.minus(middle);
                return new Point(q.x() * stretch.x(), q.y() * stretch.y(), q.z() * stretch.z());
            }));
        }
        return builder.build();
    }

    private Extent extent() {
        List<Point> all = new ArrayList<>();
        solids.forEach(solid -> all.addAll(solid.corners()));
        return Extent.of(all);
    }
}
