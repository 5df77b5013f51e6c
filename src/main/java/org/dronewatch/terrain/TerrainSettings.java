package org.dronewatch.terrain;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.input.PackagedSite;

/**
 * The ground of a real place, from elevation files: GeoTIFF, SRTM tiles (.hgt, also compressed as .zip or .gz) or ESRI
 * ASCII grids (.asc). Its centre is the scene's geographic origin, {@code world.origin}, which such a scene must state.
 *
 * @param file the elevation file, or {@code packaged:NAME} for one in the library
 * @param files several files instead, which are joined into one terrain; they must have the same grid of posts. Where
 *     they overlap, the first one that has a height there is used
 * @param crs coordinate reference system of the files by its EPSG code, such as EPSG:25832; omit it to use the one that
 *     the files state
 * @param radius radius of the circle around the origin that the terrain covers, 10 m to 100 km; the terrain is the
 *     rectangle of rows and columns of the files' grid that contains this circle
 * @param accuracy greatest vertical error that simplifying the terrain mesh may cause, 0 to 1000 m; at 0 every post
 *     is kept
 * @param surface surface that the heights describe: the bare ground (dtm), or the highest surface, including roofs and
 *     treetops (dsm)
 * @param verticalOffset offset that is added to the heights of the files, -1000 to 1000 m: for files whose heights
 *     are not measured from the same level as {@code world.origin.height}
 * @param nodata a height that means "no data", in addition to those that the files state; omit it if there is no other
 * @param material name of the ground's material, to which {@code world.surfaces} assigns an acoustic surface; a name in
 *     the table of surfaces needs no assignment
 * @param attribution credit required by the source of the elevations, at most 300 characters; {@code check}, the report
 *     and pictures of the site show it. For Copernicus files, recognised by their names, the credit is added
 *     automatically if this is omitted
 */
public record TerrainSettings(
        @FileName(unless = PackagedSite.PREFIX) Optional<String> file,
        @FileName(unless = PackagedSite.PREFIX) List<String> files,
        Optional<String> crs,
        @In(value = Quantity.LENGTH, from = 10, to = 100_000) double radius,
        @In(value = Quantity.LENGTH, from = 0, to = 1000) double accuracy,
        ElevationSurface surface,
        @In(value = Quantity.LENGTH, from = -1000, to = 1000) double verticalOffset,
        @In(Quantity.NUMBER) Optional<Double> nodata,
        String material,
        @Minor Optional<String> attribution) {
    /** The longest credit, characters. */
    private static final int LONGEST_ATTRIBUTION = 300;

    /** The notice that the licence of the Copernicus DEM requires of whoever shows it or what is made of it. */
    private static final String COPERNICUS =
            "produced using Copernicus WorldDEM-30 © DLR e.V. 2010-2014 and © Airbus Defence and Space GmbH 2014-2018"
                    + " provided under COPERNICUS by the European Union and ESA; all rights reserved";

    /** The colour of ground in daylight, that of meadows: red, green and blue in the lowest 24 bits. */
    public static final int COLOUR = 0x617838;

    /** Pasture within 2 km, with an accuracy of half a metre; without a file yet. */
    @Defaults
    public static final TerrainSettings DEFAULT = new TerrainSettings(
            Optional.empty(),
            List.of(),
            Optional.empty(),
            2000.0,
            0.5,
            ElevationSurface.DTM,
            0.0,
            Optional.empty(),
            "pasture_uncompacted",
            Optional.empty());

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range, a text is empty, or the code of the coordinate
     *     reference system is not known
     */
    public TerrainSettings {
        Limits.check(
                TerrainSettings.class,
                file,
                files,
                crs,
                radius,
                accuracy,
                surface,
                verticalOffset,
                nodata,
                material,
                attribution);
        files = List.copyOf(files);
        if (file.isPresent() && !files.isEmpty()) {
            throw new IllegalArgumentException("files and 'file' are both given: name all files under 'files'");
        }
        if (material.isBlank()) {
            throw new IllegalArgumentException("material is empty: it must be a name");
        }
        attribution.ifPresent(TerrainSettings::checkAttribution);
        CoordinateReferenceSystem.checkSetting(crs);
    }

    /** The credit to be shown with the elevations: as stated, or that of Copernicus for its files. */
    public Optional<String> credit() {
        return attribution.or(() -> allFiles().stream()
                .filter(name -> name.toLowerCase(Locale.ROOT).contains("copernicus"))
                .findFirst()
                .map(name -> COPERNICUS));
    }

    private static void checkAttribution(String text) {
        if (text.isBlank() || text.length() > LONGEST_ATTRIBUTION) {
            throw new IllegalArgumentException("attribution has " + text.strip().length()
                    + " characters but must have 1 to " + LONGEST_ATTRIBUTION);
        }
    }

    /** Terrain from a file. */
    public static TerrainSettings of(String file) {
        return SettingsForm.with(DEFAULT, "file", Optional.of(file));
    }

    /** Terrain from several files. */
    public static TerrainSettings of(List<String> files) {
        return SettingsForm.with(DEFAULT, "files", files);
    }

    /**
     * The colour of the ground in daylight, which its material determines: red, green and blue in the lowest 24 bits.
     * It is {@link #COLOUR}, that of meadows, for a material whose colour is not known.
     */
    public int colour() {
        return GroundColours.of(material);
    }

    /** The names of all files. */
    public List<String> allFiles() {
        List<String> all = new ArrayList<>(files);
        file.ifPresent(all::add);
        return List.copyOf(all);
    }

    /** These settings with another coordinate reference system, such as {@code EPSG:25832}. */
    public TerrainSettings withCrs(String code) {
        return SettingsForm.with(this, "crs", Optional.of(code));
    }

    /** These settings with another radius, m. */
    public TerrainSettings withRadius(double metres) {
        return SettingsForm.with(this, "radius", metres);
    }

    /** These settings with another greatest vertical error, m; 0 keeps every post. */
    public TerrainSettings withAccuracy(double metres) {
        return SettingsForm.with(this, "accuracy", metres);
    }

    /** These settings with heights of another surface. */
    public TerrainSettings withSurface(ElevationSurface other) {
        return SettingsForm.with(this, "surface", other);
    }

    /** These settings with another vertical offset, m. */
    public TerrainSettings withVerticalOffset(double metres) {
        return SettingsForm.with(this, "verticalOffset", metres);
    }

    /** These settings with another height that means "no data". */
    public TerrainSettings withNodata(double height) {
        return SettingsForm.with(this, "nodata", Optional.of(height));
    }

    /** These settings with ground of another material. */
    public TerrainSettings withMaterial(String name) {
        return SettingsForm.with(this, "material", name);
    }

    /** These settings with the credit required by the source of the elevations. */
    public TerrainSettings withAttribution(String text) {
        return SettingsForm.with(this, "attribution", Optional.of(text));
    }
}
