namespace Rabit.Vision.Tests.Templates;

/// <summary>A template of three generated pictures.</summary>
public sealed class TrainedCar
{
    public TrainedCar()
    {
        var trainer = new TemplateTrainer(new TemplateTrainingOptions
        {
            Name = "car",
            LengthMetres = 4.6,
            WidthMetres = 1.9,
            FalseAlarmsPerPicture = 0.5,
        });
        for (int seed = 1; seed <= 3; seed++)
        {
            var picture = CarPictures.Create(seed, 6);
            trainer.Add(picture.Picture, CarPictures.MetresPerPixel, picture.Boxes());
        }

        Result = trainer.Train();
    }

    public TemplateTrainingResult Result { get; }
}
