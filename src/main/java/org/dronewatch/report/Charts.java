package org.dronewatch.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler.LegendLayout;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The common style of all plots. */
public final class Charts {
    /** An axis in this unit is logarithmic: octaves are equally wide. */
    private static final String FREQUENCY = "[Hz]";

    private static final int WIDTH = 1200;
    private static final int HEIGHT = 640;
    private static final int TITLE_SIZE = 18;
    private static final int TEXT_SIZE = 14;
    /** Width of a letter of the legend, and of the sample of a line with the gaps around it, pixels. */
    private static final int LETTER_WIDTH = 10;

    private static final int SAMPLE_WIDTH = 50;
    private static final Color GRID = new Color(0xdddddd);
    private static final Color[] SERIES = {
        new Color(0x1f5fbf),
        new Color(0xff6a00),
        new Color(0x2a9d5c),
        new Color(0x9b3fb5),
        new Color(0xb58900),
        new Color(0xc2185b),
        new Color(0x00838f),
        new Color(0x6d4c41),
    };

    private Charts() {}

    /** An empty plot in the common style. */
    public static XYChart chart(String title, String xTitle, String yTitle) {
        XYChart chart = new XYChartBuilder()
                .width(WIDTH)
                .height(HEIGHT)
                .title(title)
                .xAxisTitle(xTitle)
                .yAxisTitle(yTitle)
                .build();
        chart.getStyler()
                .setChartBackgroundColor(Color.WHITE)
                .setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, TITLE_SIZE))
                .setLegendFont(new Font(Font.SANS_SERIF, Font.PLAIN, TEXT_SIZE))
                .setSeriesColors(SERIES);
        chart.getStyler()
                .setPlotGridLinesColor(GRID)
                .setAxisTitleFont(new Font(Font.SANS_SERIF, Font.PLAIN, TEXT_SIZE))
                .setAxisTickLabelsFont(new Font(Font.SANS_SERIF, Font.PLAIN, TEXT_SIZE))
                .setYAxisMin(0.0)
                .setLocale(Locale.ROOT);
        if (xTitle.endsWith(FREQUENCY)) {
            chart.getStyler().setXAxisLogarithmic(true).setXAxisDecimalPattern("0");
        }
        return chart;
    }

    /** The colour of a series by its index, from 0; colours repeat after the last. */
    static Color colour(int number) {
        return SERIES[number % SERIES.length];
    }

    /**
     * Draws a series as a thin grey dashed line without markers, for an analytic model or a threshold rather than a
     * result.
     */
    public static void asReference(XYSeries series) {
        asReference(series, Color.GRAY);
    }

    /** Draws a series as a thin dashed line without markers. */
    static void asReference(XYSeries series, Color colour) {
        series.setMarker(SeriesMarkers.NONE);
        series.setLineColor(colour);
        series.setLineStyle(
                new BasicStroke(2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10f, new float[] {8f, 6f}, 0f));
    }

    /** Places the legend below the plot if the names fit into one line, otherwise beside the plot. */
    private static void placeLegend(XYChart chart) {
        int line = chart.getSeriesCollection().stream()
                .mapToInt(series ->
                        SAMPLE_WIDTH + LETTER_WIDTH * series.getLabel().length())
                .sum();
        if (line < WIDTH) {
            chart.getStyler().setLegendPosition(LegendPosition.OutsideS).setLegendLayout(LegendLayout.Horizontal);
        } else {
            chart.getStyler().setLegendPosition(LegendPosition.OutsideE).setLegendLayout(LegendLayout.Vertical);
        }
    }

    /** The plot as a picture. */
    public static BufferedImage picture(XYChart chart) {
        placeLegend(chart);
        return BitmapEncoder.getBufferedImage(chart);
    }

    /** Writes the plot as PNG. */
    static void write(XYChart chart, Path file) {
        // Image I/O's own cache on disk registers with the process's shutdown, which may be under way already.
        try (OutputStream target = Files.newOutputStream(file);
                ImageOutputStream stream = new MemoryCacheImageOutputStream(target)) {
            ImageIO.write(picture(chart), "png", stream);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
