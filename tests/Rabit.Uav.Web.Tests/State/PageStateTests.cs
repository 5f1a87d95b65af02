using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using System.Text.Json;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Rabit.Uav.Web.State;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Web.Tests.State;

public sealed class PageStateTests(ITestOutputHelper output)
{
    private readonly PageState _state = new();
    private readonly byte[] _message = new byte[PageState.MaxMessageBytes];

    [Fact]
    public void Fill_RandomChanges_GivesEveryBrowserTheStateInShortMessages()
    {
        const int Seed = 20;
        output.WriteLine($"seed {Seed}");
        var random = new Random(Seed);
        var truth = new Dictionary<string, string>(StringComparer.Ordinal);
        var browsers = Enumerable.Range(0, 4).Select(_ => new Browser()).ToArray();
        for (int round = 0; round < 400; round++)
        {
            for (int change = random.Next(40); change > 0; change--)
            {
                string key = random.Next(150).ToString(CultureInfo.InvariantCulture);
                string value = $"\"{new string('x', random.Next(random.Next(10) == 0 ? 2700 : 60))}\"";
                truth[key] = value;
                Set(key, value);
            }

            // The first takes one message in each round, the last all there is.
            for (int browser = 0; browser < browsers.Length; browser++)
            {
                bool isLast = browser == browsers.Length - 1;
                Take(browsers[browser], isLast ? int.MaxValue : browser == 0 ? 1 : random.Next(4));
            }
            Assert.Equal(truth, browsers[^1].Values);
        }

        foreach (Browser browser in browsers)
        {
            Take(browser, int.MaxValue);
            Assert.Equal(truth, browser.Values);
        }
    }

    [Fact]
    public void Fill_ValueSetAsBefore_IsNoChange()
    {
        Set("a", "1");
        long has = 0;
        Assert.True(_state.Fill(ref has, _message, out bool isComplete) > 0 && isComplete);
        Set("a", "1");
        Assert.Equal(0, _state.Fill(ref has, _message, out isComplete));
        Assert.True(isComplete);
    }

    [Fact]
    public void Fill_BrowserThatWasSlow_GetsTheNewestValueOnce()
    {
        for (int value = 0; value < 1000; value++)
            Set("height", value.ToString(CultureInfo.InvariantCulture));
        long has = 0;
        int length = _state.Fill(ref has, _message, out _);
        Assert.Equal("{\"set\":{\"height\":999},\"complete\":true}", Encoding.UTF8.GetString(_message, 0, length));
    }

    [Fact]
    public void Remove_Value_IsNull()
    {
        Set("track", "1");
        _state.Remove("track");
        _state.Remove("never there");
        long has = 0;
        int length = _state.Fill(ref has, _message, out _);
        Assert.Equal("{\"set\":{\"track\":null},\"complete\":true}", Encoding.UTF8.GetString(_message, 0, length));
        Assert.Equal(1, _state.Count);
    }

    [Fact]
    public void Set_ValueThatFitsNoMessage_Throws()
        => Assert.Throws<ArgumentException>(() => Set("a", new string('1', PageState.MaxValueBytes + 1)));

    [Fact]
    public async Task News_ChangeThenSignal_Ends()
    {
        Task news = _state.News;
        _state.Signal();
        Assert.False(news.IsCompleted);
        Set("a", "1");
        Assert.False(news.IsCompleted);
        _state.Signal();
        await news.WaitAsync(TestTimeout.Limit);
        Assert.False(_state.News.IsCompleted);
    }

    [Fact]
    public void Write_TextsOfTheWorstKind_FitAMessage()
    {
        using var writer = new ItemWriter(_state);
        string worst = new('ก', 5000);
        string quotes = new('"', 5000);
        foreach (string text in new[] { worst, quotes, new string('\u0001', 5000), new string('\ud800', 5000) })
        {
            writer.Object("0/mission").Text("a", text).Text("b", text).Text("c", text).Text("d", text, 80).End();
            long has = 0;
            int length = _state.Fill(ref has, _message, out bool isComplete);
            Assert.True(isComplete);
            using JsonDocument message = JsonDocument.Parse(_message.AsMemory(0, length));
            Assert.Equal(
                ItemWriter.MaxTextLength,
                message.RootElement.GetProperty("set").GetProperty("0/mission").GetProperty("a").GetString()!.Length);
        }
    }

    private void Set(string key, string json) => _state.Set(key, Encoding.UTF8.GetBytes(json));

    private void Take(Browser browser, int messages)
    {
        for (; messages > 0; messages--)
        {
            int length = _state.Fill(ref browser.Has, _message, out bool isComplete);
            Assert.InRange(length, 0, PageState.MaxMessageBytes);
            if (length > 0)
            {
                using JsonDocument message = JsonDocument.Parse(_message.AsMemory(0, length));
                foreach (JsonProperty set in message.RootElement.GetProperty("set").EnumerateObject())
                    browser.Values[set.Name] = set.Value.GetRawText();
                Assert.Equal(isComplete, message.RootElement.GetProperty("complete").GetBoolean());
            }

            if (isComplete)
                return;
        }
    }

    private sealed class Browser
    {
        public long Has;

        public Dictionary<string, string> Values { get; } = new(StringComparer.Ordinal);
    }
}
