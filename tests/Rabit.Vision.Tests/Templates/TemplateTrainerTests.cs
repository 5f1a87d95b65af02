using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Tests.Shared;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Vision.Tests.Templates;

/// <summary>Training and searching with generated pictures; the template is trained once for all tests.</summary>
public sealed class TemplateTrainerTests(TrainedCar trained, ITestOutputHelper output) : IClassFixture<TrainedCar>
{
    [Fact]
    public void Train_GeneratedCars_FindsThoseOfOtherPictures()
    {
        TemplateTrainingResult result = trained.Result;
        output.WriteLine(FormattableString.Invariant(
            $"left out: recall {result.Recall:0.00}, {result.FalseAlarmsPerPicture:0.00} false alarms, sigma {result.Template.SigmaMetres:0.00} m"));
        Assert.Equal((3, 3, 18), (result.Folds, result.Pictures, result.Objects));
        Assert.InRange(result.Recall, 0.9, 1);
        Assert.InRange(result.FalseAlarmsPerPicture, 0, 1);
        (int found, int of, int wrong) = (0, 0, 0);
        for (int seed = 101; seed <= 103; seed++)
        {
            var picture = CarPictures.Create(seed, 6);
            List<TemplateMatch> matches =
                Scan(result.Template, picture, PlaneScale.Uniform(CarPictures.MetresPerPixel));
            foreach ((double x, double y, double heading) in picture.Cars)
            {
                of++;
                int index = matches.FindIndex(m => Distance(m, x, y) < 1);
                if (index < 0)
                    continue;
                found++;
                output.WriteLine(FormattableString.Invariant(
                    $"{Distance(matches[index], x, y):0.00} m, {Turn(matches[index].HeadingRadians, heading):0.0} degrees off, {matches[index].Probability:0.00}"));
                Assert.InRange(Distance(matches[index], x, y), 0, 0.5);
                Assert.InRange(Turn(matches[index].HeadingRadians, heading), 0, 8);
                matches.RemoveAt(index);
            }

            wrong += matches.Count;
        }

        output.WriteLine($"{found} of {of} found, {wrong} false alarms");
        Assert.True(found >= of - 1 && wrong <= 3, $"{found} of {of} found, {wrong} false alarms");
    }

    // The plane turned, stretched along the rows and finer: the same cars at headings of the plane.
    [Fact]
    public void Scan_ScaleOfATurnedPlane_GivesHeadingsOfThePlane()
    {
        var picture = CarPictures.Create(104, 6);
        const double turn = 0.7;
        double cos = Math.Cos(turn) * CarPictures.MetresPerPixel;
        double sin = Math.Sin(turn) * CarPictures.MetresPerPixel;
        var scale = new PlaneScale(-sin, -cos, cos, -sin);
        List<TemplateMatch> matches = Scan(trained.Result.Template, picture, scale);
        int found = 0;
        foreach ((double x, double y, double heading) in picture.Cars)
        {
            int index = matches.FindIndex(m => Distance(m, x, y) < 1);
            if (index < 0)
                continue;
            found++;
            Assert.InRange(Turn(matches[index].HeadingRadians, heading + turn), 0, 8);
        }

        Assert.InRange(found, 5, 6);
    }

    [Fact]
    public void Scan_FurtherPictures_FindsTheSameAndAllocatesNothing()
    {
        var picture = CarPictures.Create(105, 6);
        var scanner = new TemplateScanner(trained.Result.Template);
        TemplateMatch[] Once()
        {
            scanner.Begin(picture.Picture.Pixels, CarPictures.Width, CarPictures.Height);
            Assert.True(scanner.Scan(
                PlaneScale.Uniform(CarPictures.MetresPerPixel), 0, 0, CarPictures.Width - 1, CarPictures.Height - 1));
            return scanner.Finish().ToArray();
        }

        TemplateMatch[] first = Once();
        Assert.Equal(first, Once());
        PlaneScale scale = PlaneScale.Uniform(CarPictures.MetresPerPixel);
        ReadOnlyMemory<byte> pixels = picture.Picture.Pixels;
        Assert.Equal(0, Allocated.By(() =>
        {
            scanner.Begin(pixels, CarPictures.Width, CarPictures.Height);
            scanner.Scan(scale, 0, 0, CarPictures.Width - 1, CarPictures.Height - 1);
            scanner.Finish();
        }));
    }

    [Fact]
    public void Scan_PixelsTooCoarse_SearchesNothing()
    {
        var scanner = new TemplateScanner(trained.Result.Template);
        scanner.Begin(new byte[300], 10, 10);
        Assert.False(scanner.Scan(PlaneScale.Uniform(0.4), 0, 0, 9, 9));
        Assert.True(scanner.Scan(PlaneScale.Uniform(0.01), 0, 0, 9, 9));   // smaller than a window
        Assert.Equal(0, scanner.Finish().Length);
        Assert.Throws<ArgumentException>(() => scanner.Begin(new byte[299], 10, 10));
    }

    [Fact]
    public void Train_SamePicturesAgain_GivesTheSameFile()
    {
        byte[] Once()
        {
            var trainer = new TemplateTrainer(new TemplateTrainingOptions { LengthMetres = 4.6, WidthMetres = 1.9 });
            var picture = CarPictures.Create(1, 5);
            trainer.Add(picture.Picture, CarPictures.MetresPerPixel, picture.Boxes());
            return TemplateFile.Format(trainer.Train().Template);
        }

        Assert.Equal(Once(), Once());
    }

    [Fact]
    public void Train_Cancelled_Ends()
    {
        var trainer = new TemplateTrainer(new TemplateTrainingOptions());
        var picture = CarPictures.Create(1, 5);
        trainer.Add(picture.Picture, CarPictures.MetresPerPixel, picture.Boxes());
        Assert.Throws<OperationCanceledException>(() => trainer.Train(null, new CancellationToken(true)));
    }

    [Fact]
    public void Train_TooFewObjects_SaysHowMany()
    {
        var trainer = new TemplateTrainer(new TemplateTrainingOptions());
        var picture = CarPictures.Create(1, 3);
        trainer.Add(picture.Picture, CarPictures.MetresPerPixel, picture.Boxes());
        var error = Assert.Throws<InvalidOperationException>(() => trainer.Train());
        Assert.Equal("There are 3 objects to train with; at least 4 are needed.", error.Message);
    }

    [Fact]
    public void Add_WrongInput_NamesIt()
    {
        var trainer = new TemplateTrainer(new TemplateTrainingOptions());
        var picture = new RgbPicture(20, 10, new byte[600]);
        TrainingBox[] wrong =
        [
            new(0, 0, 0, 5), new(20, 0, 5, 5), new(0, -6, 5, 5), new(double.NaN, 0, 5, 5), new(0, 0, 41, 5),
        ];
        Assert.All(wrong, b => Assert.Contains(
            "is not in the picture", Assert.Throws<ArgumentException>(() => trainer.Add(picture, 0.1, [b])).Message,
            StringComparison.Ordinal));
        Assert.Contains(
            "too coarse", Assert.Throws<ArgumentException>(() => trainer.Add(picture, 0.3, [])).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Create_OptionsOutOfRange_NamesAll()
    {
        var error = Assert.Throws<ArgumentException>(() => new TemplateTrainer(new TemplateTrainingOptions
        {
            Name = "",
            LengthMetres = 1,
            WidthMetres = 2,
            FalseAlarmsPerPicture = 0,
        }));
        Assert.All(
            ["name", "the length first", "FalseAlarmsPerPicture"],
            part => Assert.Contains(part, error.Message, StringComparison.Ordinal));
    }

    private static List<TemplateMatch> Scan(ObjectTemplate template, CarPictures picture, PlaneScale scale)
    {
        var scanner = new TemplateScanner(template);
        scanner.Begin(picture.Picture.Pixels, CarPictures.Width, CarPictures.Height);
        scanner.Scan(scale, 0, 0, CarPictures.Width - 1, CarPictures.Height - 1);
        return [.. scanner.Finish().ToArray()];
    }

    private static double Distance(TemplateMatch match, double x, double y)
        => CarPictures.MetresPerPixel * Math.Sqrt(
            ((match.CentreX - x) * (match.CentreX - x)) + ((match.CentreY - y) * (match.CentreY - y)));

    // Degrees between two lines.
    private static double Turn(double a, double b) => Math.Asin(Math.Abs(Math.Sin(a - b))) * 180 / Math.PI;
}
