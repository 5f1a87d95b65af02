using System.Text;
using Rabit.Uav.ImageProcessing;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

public class MetadataRecordsTests
{
    private readonly MetadataRecords _records = new();

    [Fact]
    public void Add_Records_GivesEachByItself()
    {
        Add("AeLocked=false\nExposureTime=4990\nSensorTimestamp=123456789012\n");
        Assert.Equal(0, _records.Count);

        Add("\n");
        Assert.Equal((1, 123_456_789_012, 4990), Read());

        Add("SensorTimestamp=123489789012\nGain=1.5\n\n");
        Assert.Equal((2, 123_489_789_012, null), Read());

        Add("ExposureTime=8\n\n");
        Assert.Equal((3, null, 8), Read());
    }

    [Theory]
    [InlineData("SensorTimestamp=\n")]
    [InlineData("SensorTimestamp=-5\n")]
    [InlineData("SensorTimestamp=1.5\n")]
    [InlineData("SensorTimestamp=1234567890123456789\n")]
    [InlineData("SensorTimestamps=5\n")]
    [InlineData("sensortimestamp=5\n")]
    [InlineData(" SensorTimestamp=5\n")]
    [InlineData("XSensorTimestamp=5\n")]
    public void Add_WhatIsNoTime_GivesNone(string line)
    {
        Add(line + "\n");

        Assert.Equal((1, null, null), Read());
    }

    [Fact]
    public void Add_EmptyLinesAndLongOnes_AreNoRecords()
    {
        Add("\n\n\n" + new string('x', 100_000) + "SensorTimestamp=5\n");
        Assert.Equal(0, _records.Count);

        Add("SensorTimestamp=7\n\n\n\n");
        Assert.Equal((1, 7, null), Read());
    }

    [Fact]
    public void Clear_InARecord_BeginsAgain()
    {
        Add("SensorTimestamp=5\n\nSensorTimestamp=6\nExpo");

        _records.Clear();
        Add("ExposureTime=9\n\n");

        Assert.Equal((1, null, 9), Read());
    }

    private (long Count, long? Stamp, long? Exposure) Read()
        => (_records.Count, _records.StampNanoseconds, _records.ExposureMicroseconds);

    private void Add(string text)
    {
        foreach (byte next in Encoding.ASCII.GetBytes(text))
            _records.Add(next);
    }
}
