using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace Rabit.Vision;

/// <summary>
/// Trains a template from labelled pictures: a linear support vector machine on histograms of oriented gradients, in
/// rounds in which what was wrongly found becomes an example of what the object is not. How well it does is measured on
/// pictures that are left out. The same pictures give the same template. One thread.
/// </summary>
/// <example>
/// Cars, from two pictures whose pixels are 6 cm large on the ground:
/// <code>
/// var trainer = new TemplateTrainer(new TemplateTrainingOptions { Name = "car" });
/// trainer.Add(PictureFile.Load("a.jpg"), 0.06, [new TrainingBox(212, 80, 76, 34), new TrainingBox(260, 300, 36, 80)]);
/// trainer.Add(PictureFile.Load("b.jpg"), 0.06, [new TrainingBox(101, 45, 70, 62)]);
/// TemplateTrainingResult result = trainer.Train();
/// result.Template.Save("car.template");
/// </code>
/// </example>
public sealed class TemplateTrainer
{
    /// <summary>With how many objects a template is trained at least.</summary>
    public const int MinObjects = 4;

    // What is so much longer than the object is another thing, as a bus among cars.
    private const double MaxLength = 1.5625;
    private const int MaxFolds = 4;
    private const double MaxScaleOff = 1.5;

    private readonly TemplateTrainingOptions _options;
    private readonly ObjectTemplate _shape;
    private readonly List<TrainingPicture> _pictures = [];

    /// <summary>Makes a trainer.</summary>
    /// <param name="options">What to train for; read once, here.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public TemplateTrainer(TemplateTrainingOptions options)
    {
        _options = options ?? throw new ArgumentNullException(nameof(options));
        string[] faults = options.FindFaults().ToArray();
        if (faults.Length > 0)
            throw new ArgumentException("Template: " + string.Join("; ", faults) + ".", nameof(options));
        _shape = options.CreateTemplate();
    }

    /// <summary>Adds a picture; it is not kept.</summary>
    /// <param name="picture">The picture, from above.</param>
    /// <param name="metresPerPixel">Side of a pixel on the ground.</param>
    /// <param name="boxes">All objects that it shows; none makes it an example of what the object is not.</param>
    /// <param name="group">
    /// Pictures that show the same things, as those of one video, have one group: they are left out together. Null: a
    /// group of its own.
    /// </param>
    /// <exception cref="ArgumentException">
    /// A box is empty or lies outside, or pixels are too coarse for the object.
    /// </exception>
    public void Add(RgbPicture picture, double metresPerPixel, IReadOnlyList<TrainingBox> boxes, string? group = null)
    {
        if (picture is null)
            throw new ArgumentNullException(nameof(picture));
        if (boxes is null)
            throw new ArgumentNullException(nameof(boxes));
        if (!(metresPerPixel > 0 && metresPerPixel <= MaxScaleOff * _shape.MetresPerPixel))
        {
            throw new ArgumentException(
                FormattableString.Invariant(
                    $"Pixels of {metresPerPixel} m are too coarse: at most {MaxScaleOff * _shape.MetresPerPixel} m show the object."),
                nameof(metresPerPixel));
        }

        foreach (TrainingBox box in boxes)
            Check(box, picture);
        var added = new TrainingPicture
        {
            Scale = PlaneScale.Uniform(metresPerPixel),
            Group = group ?? FormattableString.Invariant($"picture {_pictures.Count + 1}"),
            Frame = new PixelRectangle(0, 0, picture.Width - 1, picture.Height - 1),
        };
        added.Plane.Set(
            picture.Pixels, picture.Width, picture.Height, TemplateScanner.FactorOf(added.Scale, _shape));
        foreach (TrainingBox box in boxes)
        {
            if (box.IsIgnored || Math.Max(box.Width, box.Height) * metresPerPixel > MaxLength * _shape.LengthMetres)
                added.Ignored.Add(box.Box);
            else
                added.Objects.Add(TrainingObject.From(box, _shape.WidthMetres / _shape.LengthMetres));
        }

        _pictures.Add(added);
    }

    /// <summary>Trains. Takes seconds to minutes.</summary>
    /// <param name="onProgress">Receives which part of it is done, 0 to 1; null for none.</param>
    /// <param name="cancellation">Ends it before its end.</param>
    /// <exception cref="InvalidOperationException">
    /// There are fewer than <see cref="MinObjects"/> objects; the message says how many.
    /// </exception>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    public TemplateTrainingResult Train(
        Action<double>? onProgress = null, CancellationToken cancellation = default)
    {
        int objects = _pictures.Sum(p => p.Objects.Count);
        if (objects < MinObjects)
            throw new InvalidOperationException(
                $"There are {objects} objects to train with; at least {MinObjects} are needed.");
        List<TrainingPicture>[] folds = Folds();
        int trainings = folds.Length + 1;
        int done = 0;
        void Progress(double part) => onProgress?.Invoke((done + part) / trainings);
        var held = new HeldOutScores();
        foreach (List<TrainingPicture> fold in folds)
        {
            List<TrainingPicture> others = _pictures.Except(fold).ToList();
            if (others.Sum(p => p.Objects.Count) >= MinObjects)
            {
                ObjectTemplate template = new TemplateTraining(others, _options).Train(Progress, cancellation);
                foreach (TrainingPicture picture in fold)
                    held.Add(picture, template, cancellation);
            }

            done++;
        }

        ObjectTemplate last = new TemplateTraining(_pictures, _options).Train(Progress, cancellation);
        var result = new TemplateTrainingResult(last)
        {
            Pictures = _pictures.Count,
            Objects = objects,
            Ignored = _pictures.Sum(p => p.Ignored.Count),
            Folds = folds.Length,
        };
        held.Calibrate(result, _options.FalseAlarmsPerPicture);
        onProgress?.Invoke(1);
        return result;
    }

    private static void Check(TrainingBox box, RgbPicture picture)
    {
        if (box is null || !(box.Width > 0 && box.Height > 0
            && box.Left + box.Width > 0 && box.Top + box.Height > 0
            && box.Left < picture.Width && box.Top < picture.Height
            && box.Width <= 2.0 * picture.Width && box.Height <= 2.0 * picture.Height))
        {
            throw new ArgumentException(box is null
                ? "A box is null."
                : FormattableString.Invariant(
                    $"The box {box.Left}, {box.Top}, {box.Width} x {box.Height} is not in the picture of {picture.Width} x {picture.Height} pixels."),
                nameof(box));
        }
    }

    // Groups in turn: a fold has whole ones.
    private List<TrainingPicture>[] Folds()
    {
        string[] groups = _pictures.Select(p => p.Group).Distinct(StringComparer.Ordinal).ToArray();
        if (groups.Length < 2)
            return [];
        int count = Math.Min(MaxFolds, groups.Length);
        return Enumerable.Range(0, count)
            .Select(f => _pictures.Where(p => Array.IndexOf(groups, p.Group) % count == f).ToList())
            .ToArray();
    }
}
