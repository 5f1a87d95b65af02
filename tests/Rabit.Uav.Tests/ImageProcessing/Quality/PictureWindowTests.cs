using System;
using Rabit.Uav.ImageProcessing.Quality;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Quality;

public class PictureWindowTests
{
    private readonly PictureWindow _window = new(TimeSpan.FromSeconds(1.5), TimeSpan.FromSeconds(10));

    [Fact]
    public void Update_FewerThanFourPictures_SaysNothing()
    {
        for (int i = 0; i < 3; i++)
            _window.Add(PictureQuality.Black, TimeSpan.FromSeconds(i));
        _window.Update(TimeSpan.FromSeconds(3));
        Assert.Null(_window.UsableShare);
    }

    [Fact]
    public void Update_SomeUnusable_GivesShareAndMainCause()
    {
        for (int i = 0; i < 100; i++)
            _window.Add(PictureQuality.White, TimeSpan.FromSeconds(1));
        for (int i = 0; i < 10; i++)
            _window.Add(
                i < 4 ? PictureQuality.Usable : i < 7 ? PictureQuality.Defocused : PictureQuality.Frozen,
                TimeSpan.FromSeconds(9 + (i / 10.0)));
        _window.Add(PictureQuality.Frozen, TimeSpan.FromSeconds(9.9));
        _window.Update(TimeSpan.FromSeconds(10));
        Assert.Equal(
            (4 / 11.0, PictureQuality.Frozen, 4 / 11.0),
            (_window.UsableShare, _window.MainCause, _window.CauseShare));
    }

    [Fact]
    public void Update_SlowCamera_CountsTheLastFourOfTenSeconds()
    {
        for (int i = 0; i < 10; i++)
            _window.Add(i < 8 ? PictureQuality.Usable : PictureQuality.Black, TimeSpan.FromSeconds(2 * i));
        _window.Update(TimeSpan.FromSeconds(19));
        Assert.Equal(0.5, _window.UsableShare);
        _window.Update(TimeSpan.FromSeconds(40));
        Assert.Null(_window.UsableShare);
    }

    // A manoeuvre is no fault of the camera; a tilt that lasts is.
    [Theory]
    [InlineData(4.5, 1.0)]
    [InlineData(8.0, 0.0)]
    public void Add_TiltedAway_CountsOnlyAfterSomeSeconds(double seconds, double usable)
    {
        for (int i = 0; i < 10; i++)
            _window.Add(PictureQuality.Usable, TimeSpan.FromSeconds(i / 5.0));
        double now = 2;
        for (; now <= 2 + seconds; now += 0.2)
            _window.Add(PictureQuality.NotGround, TimeSpan.FromSeconds(now), isByManoeuvre: true);
        _window.Update(TimeSpan.FromSeconds(now));
        Assert.Equal(usable, _window.UsableShare);
    }

    [Fact]
    public void Clear_ForgetsAll()
    {
        for (int i = 0; i < 5; i++)
            _window.Add(PictureQuality.Black, TimeSpan.Zero);
        _window.Update(TimeSpan.Zero);
        Assert.Equal(0, _window.UsableShare);
        _window.Clear();
        _window.Update(TimeSpan.Zero);
        Assert.Null(_window.UsableShare);
    }
}
