namespace Rabit.Uav.Messages;

/// <summary>What is wrong with pictures, as text: for the status, Health Monitoring, screen and report.</summary>
public static class PictureQualityText
{
    /// <summary>A few words that follow a number of pictures: "100 % black". A constant.</summary>
    /// <param name="quality">What they are.</param>
    public static string Of(PictureQuality quality) => quality switch
    {
        PictureQuality.Usable => "usable",
        PictureQuality.RepeatedNumber => "with repeated numbers",
        PictureQuality.NoPose => "without pose",
        PictureQuality.NotGround => "not of the ground",
        PictureQuality.NotSearched => "not searched",
        PictureQuality.TooCoarse => "too coarse for the smallest target",
        PictureQuality.Black => "black",
        PictureQuality.White => "white",
        PictureQuality.Saturated => "saturated",
        PictureQuality.Uniform => "of one colour",
        PictureQuality.Frozen => "frozen",
        PictureQuality.Covered => "covered",
        PictureQuality.Defocused => "defocused",
        PictureQuality.MotionBlurred => "motion-blurred",
        _ => quality.ToString(),
    };

    /// <summary>Why one picture was not searched; a constant, which costs no allocation.</summary>
    internal static string RefusalOf(PictureQuality quality) => quality switch
    {
        PictureQuality.TooCoarse => "the pixels are too large on the ground for the smallest target class",
        PictureQuality.RepeatedNumber => "the picture has the number of the one before it",
        PictureQuality.Black => "the picture is black",
        PictureQuality.White => "the picture is white",
        PictureQuality.Saturated => "the picture is saturated",
        PictureQuality.Uniform => "the picture is of one colour",
        PictureQuality.Frozen => "the picture is that of an earlier moment: the camera is frozen",
        PictureQuality.Covered => "the picture is covered in part",
        PictureQuality.Defocused => "the picture is defocused",
        PictureQuality.MotionBlurred => "the picture is motion-blurred",
        _ => "the picture cannot be used",
    };
}
