package org.dronewatch.setting.input;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Files of one kind where another is expected. */
class FileKindTest {
    private static Optional<String> misplaced(String name, String start, String wanted) {
        return FileKind.misplaced(name, start.getBytes(StandardCharsets.ISO_8859_1), wanted);
    }

    /** The beginnings that the formats' own descriptions require; spaces are for reading. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            ignoreLeadingAndTrailingWhitespace = false,
            value = {
                "dem.tif|II*\0\10\0\0\0|world.buildings|a TIFF file, which belongs under world.terrain",
                "dem.tif|MM\0*\0\0\0\10|world.models|a TIFF file, which belongs under world.terrain",
                "big.tif|MM\0+\0\10\0\0|world.buildings|a TIFF file, which belongs under world.terrain",
                "dem.asc|NCOLS 40|world.buildings|an ESRI ASCII grid, which belongs under world.terrain",
                "N43E007.HGT|\0\1\0\2|world.buildings|an SRTM tile, which belongs under world.terrain",
                "hall.ifc|ISO-10303-21;|world.terrain|an IFC model, which belongs under world.models",
                "hall.glb|glTF\2\0\0\0|world.buildings|a glTF model, which belongs under world.models",
                "hall.ply|ply\rformat ascii 1.0|world.terrain|a PLY model, which belongs under world.models",
                "hall.txt|solid hall|world.terrain|an STL model, which belongs under world.models",
                "hall.stl|\0\0\0\0|world.buildings|an STL model, which belongs under world.models",
                "hall.obj|v 0 0 0|world.terrain|an OBJ model, which belongs under world.models",
                "map|<?xml version='1.0'?><osm version='0.6'>|world.terrain|an OpenStreetMap extract, which belongs under world.buildings",
                "map|\0\0\0\16OSMHeader|world.terrain|an OpenStreetMap extract, which belongs under world.buildings",
                "map| {type|world.terrain|a JSON file, which belongs under world.buildings",
            })
    void whereItBelongsIsSaid(String name, String start, String wanted, String words) {
        assertThat(misplaced(name, start, wanted)).contains("is " + words + ", not under " + wanted);
    }

    @Test
    void nothingIsSaidOfWhatIsNotKnownOrBelongsThere() {
        assertThat(misplaced("notes.txt", "solidarity", "world.terrain")).isEmpty();
        assertThat(misplaced("page.html", "<html>", "world.terrain")).isEmpty();
        assertThat(misplaced("dem.tif", "II*\0", "world.terrain")).isEmpty();
        assertThat(misplaced("short", "I", "world.terrain")).isEmpty();
        assertThat(misplaced("dem.tif", "", "world.terrain")).contains("is empty");
    }
}
