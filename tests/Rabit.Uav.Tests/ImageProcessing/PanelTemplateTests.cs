using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// The template that tests load is what a training gives. RABIT_UPDATE_TEMPLATE=1 writes it again.
/// </summary>
public sealed class PanelTemplateTests
{
    // Sums of floats in another order, as another processor's vectors add them, move the last digits only.
    private const double Tolerance = 1e-3;

    [Fact]
    [Trait("Category", "Long")]
    public void Train_PaintedPanels_GivesTheKeptTemplate()
    {
        string path = Path.Combine(Path.GetTempPath(), Guid.NewGuid().ToString("N"));
        try
        {
            PanelTemplate.Train().Save(path);
            if (Environment.GetEnvironmentVariable("RABIT_UPDATE_TEMPLATE") == "1")
                File.Copy(path, PanelTemplate.FilePath, overwrite: true);

            string[] kept = Words(PanelTemplate.FilePath);
            string[] trained = Words(path);
            Assert.Equal(kept.Length, trained.Length);
            Assert.All(kept.Zip(trained, (k, t) => (k, t)), pair => Assert.True(
                IsNear(pair.k, pair.t), $"{pair.t} instead of {pair.k}"));
        }
        finally
        {
            File.Delete(path);
        }
    }

    // All but the checksum, which is the last line.
    private static string[] Words(string path)
    {
        string[] lines = File.ReadAllLines(path);
        return [.. lines.Take(lines.Length - 1).SelectMany(l => l.Split(' '))];
    }

    private static bool IsNear(string kept, string trained) => kept == trained
        || (double.TryParse(kept, NumberStyles.Float, CultureInfo.InvariantCulture, out double k)
            && double.TryParse(trained, NumberStyles.Float, CultureInfo.InvariantCulture, out double t)
            && Math.Abs(k - t) < Tolerance);
}
