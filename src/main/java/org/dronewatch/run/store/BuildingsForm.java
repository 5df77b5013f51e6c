package org.dronewatch.run.store;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dronewatch.buildings.BuildingOutline;
import org.dronewatch.buildings.LoadedBuildings;
import org.dronewatch.buildings.land.LandRaster;
import org.dronewatch.geometry.TriangleMesh;

/** The form of buildings; {@link StoredForms} describes the layout. */
final class BuildingsForm implements StoredForm<LoadedBuildings> {
    /** Bytes of an outline whose texts and arrays are empty. */
    private static final int SHORTEST_OUTLINE = 40;

    @Override
    public void write(LoadedBuildings value, StoreWriter target) throws IOException {
        StoredForms.addMesh(value.mesh(), target);
        StoredForms.addMesh(value.woods(), target);
        target.addInt(value.colours().size());
        for (Map.Entry<String, Integer> colour : new TreeMap<>(value.colours()).entrySet()) {
            target.addText(colour.getKey());
            target.addInt(colour.getValue());
        }
        target.addInt(value.outlines().size());
        for (BuildingOutline outline : value.outlines()) {
            addOutline(outline, target);
        }
        StoredForms.addOptional(value.attribution(), target);
        target.addInt(value.count());
        target.addDouble(value.area());
        target.addInt(value.assumed());
        StoredForms.addFile(value.file(), target);
        target.addInts(value.landCover().map(LandRaster::runs).orElse(new int[0]));
        target.addInt(value.landCover().map(LandRaster::side).orElse(0));
        target.addDouble(value.landCover().map(LandRaster::half).orElse(0.0));
        target.addTexts(value.description());
        target.addTexts(value.warnings());
    }

    private static void addOutline(BuildingOutline outline, StoreWriter target) throws IOException {
        target.addText(outline.id());
        StoredForms.addOptional(outline.name(), target);
        target.addInt(outline.isPart() ? 1 : 0);
        target.addDoubles(outline.outer());
        target.addInt(outline.courts().size());
        for (double[] court : outline.courts()) {
            target.addDoubles(court);
        }
        target.addDouble(outline.bottom());
        target.addDouble(outline.top());
        target.addInt(outline.isAssumed() ? 1 : 0);
    }

    @Override
    public LoadedBuildings read(StoreReader source) throws IOException {
        TriangleMesh mesh = StoredForms.nextMesh(source);
        TriangleMesh woods = StoredForms.nextMesh(source);
        Map<String, Integer> colours = new HashMap<>();
        for (int left = source.length(2 * Integer.BYTES); left > 0; left--) {
            colours.put(source.nextText(), source.nextInt());
        }
        List<BuildingOutline> outlines = new ArrayList<>();
        for (int left = source.length(SHORTEST_OUTLINE); left > 0; left--) {
            outlines.add(nextOutline(source));
        }
        Optional<String> attribution = StoredForms.nextOptional(source);
        return new LoadedBuildings(
                mesh,
                woods,
                colours,
                outlines,
                attribution,
                source.nextInt(),
                source.nextDouble(),
                source.nextInt(),
                StoredForms.nextFile(source),
                nextLandCover(source),
                source.nextTexts(),
                source.nextTexts());
    }

    private static Optional<LandRaster> nextLandCover(StoreReader source) throws IOException {
        int[] runs = source.nextInts();
        int side = source.nextInt();
        double half = source.nextDouble();
        return side == 0 ? Optional.empty() : Optional.of(LandRaster.ofRuns(half, side, runs));
    }

    private static BuildingOutline nextOutline(StoreReader source) throws IOException {
        String id = source.nextText();
        Optional<String> name = StoredForms.nextOptional(source);
        boolean isPart = source.nextInt() == 1;
        double[] outer = source.nextDoubles();
        List<double[]> courts = new ArrayList<>();
        for (int left = source.length(Integer.BYTES); left > 0; left--) {
            courts.add(source.nextDoubles());
        }
        double bottom = source.nextDouble();
        return new BuildingOutline(id, name, isPart, outer, courts, bottom, source.nextDouble(), source.nextInt() == 1);
    }
}
