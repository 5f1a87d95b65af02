using System;
using System.Linq;
using System.Net;
using System.Net.Http;
using System.Net.Http.Headers;
using System.Text;
using System.Threading.Tasks;
using Rabit.Uav.Messages;
using Rabit.Uav.Web.Serving;
using Xunit;

namespace Rabit.Uav.Web.Tests.Serving;

/// <summary>Who may command, what, and how often.</summary>
public sealed class CommandTests
{
    [Theory]
    [InlineData("""{"command":"hold"}""", OperatorCommand.Hold, "hold")]
    [InlineData("""{"command":"return","vehicle":0}""", OperatorCommand.Return, "return")]
    [InlineData("""{"command":"continue"}""", OperatorCommand.Continue, "continue")]
    [InlineData("""{"command":"land"}""", OperatorCommand.Land, "land")]
    [InlineData("""{"command":"skip"}""", OperatorCommand.SkipLane, "skip lane")]
    [InlineData("""{"command":"revisit","track":3}""", OperatorCommand.Revisit, "revisit track 3")]
    [InlineData("""{"command":"confirm","track":4}""", OperatorCommand.Confirm, "confirm track 4")]
    [InlineData("""{"command":"reject","track":5}""", OperatorCommand.Reject, "reject track 5")]
    [InlineData("""{"command":"visit","latitude":47.5,"longitude":8.5}""", OperatorCommand.RevisitPlace, "revisit 47.50000, 8.50000")]
    [InlineData("""{"command":"speed","metresPerSecond":4.5}""", OperatorCommand.ChangeSpeed, "change speed to 4.5 m/s")]
    [InlineData("""{"command":"set","parameter":"Height","value":40}""", OperatorCommand.ChangeParameter, "set Height to 40")]
    public async Task Post_WithTheToken_IsGiven(string body, OperatorCommand command, string name)
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using HttpResponseMessage answer = await PostAsync(page, body);
        Assert.Equal(HttpStatusCode.Accepted, answer.StatusCode);
        OperatorRequest request = Assert.Single(page.Operator.Given);
        Assert.Equal((command, name), (request.Command, request.Name));
        Assert.Equal("browser at 127.0.0.1", request.By);
        Assert.Equal((1, 0), (page.Page.Counters.Commands, page.Page.Counters.CommandsRefused));
    }

    [Theory]
    [InlineData("", "The body is no JSON.")]
    [InlineData("[]", "no JSON object")]
    [InlineData("""{"command":"explode"}""", "command: it must be one of hold, return")]
    [InlineData("""{"command":3}""", "command: it must be one of")]
    [InlineData("""{"command":"hold","vehicle":-1}""", "vehicle: it must be a number from 0.")]
    [InlineData("""{"command":"revisit"}""", "track: it must be the number of a track.")]
    [InlineData("""{"command":"revisit","track":1.5}""", "track: it must be")]
    [InlineData("""{"command":"visit","latitude":91,"longitude":0}""", "latitude, longitude")]
    [InlineData("""{"command":"speed","metresPerSecond":"fast"}""", "metresPerSecond: it must be a number.")]
    [InlineData("""{"command":"set","parameter":"77","value":40}""", "parameter: it must be one of Height")]
    [InlineData("""{"command":"set","parameter":"Colour","value":40}""", "parameter: it must be one of Height")]
    [InlineData("""{"command":"hold","a":[[[[[[1]]]]]]}""", "The body is no JSON.")]
    [InlineData("""{"command":"hold","command":"land"}""", "Nothing may be named twice")]
    [InlineData("""{"command":"\ud800"}""", "The body is no JSON.")]
    [InlineData("""{"command":"set","parameter":"\ud800","value":1}""", "The body is no JSON.")]
    [InlineData("""{"command":"set","parameter":"0","value":1}""", "parameter: it must be one of Height")]
    public async Task Post_Malformed_IsRefusedByName(string body, string fault)
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using HttpResponseMessage answer = await PostAsync(page, body);
        Assert.Equal(HttpStatusCode.BadRequest, answer.StatusCode);
        Assert.Contains(fault, await answer.Content.ReadAsStringAsync(), StringComparison.Ordinal);
        Assert.Empty(page.Operator.Given);
        Assert.Equal((0, 1), (page.Page.Counters.Commands, page.Page.Counters.CommandsRefused));
    }

    [Theory]
    [InlineData(null)]
    [InlineData("")]
    [InlineData("a-token-that-tests-know-012")]
    [InlineData("a-token-that-tests-know-01234")]
    [InlineData("A-TOKEN-THAT-TESTS-KNOW-0123")]
    public async Task Post_WithoutTheToken_IsRefused(string? token)
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using HttpResponseMessage answer = await PostAsync(page, """{"command":"hold"}""", token);
        Assert.Equal(HttpStatusCode.Unauthorized, answer.StatusCode);
        Assert.Empty(page.Operator.Given);
        Assert.Equal(1, page.Page.Counters.CommandsRefused);
    }

    [Fact]
    public async Task Post_TokenInTheAddress_IsRefused()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using HttpResponseMessage answer = await PostAsync(
            page, """{"command":"hold"}""", token: null, path: "/command?token=" + EmptyPage.Token);
        Assert.Equal(HttpStatusCode.Unauthorized, answer.StatusCode);
    }

    [Fact]
    public async Task Post_PageWithoutAToken_IsReadOnly()
    {
        await using EmptyPage page = await EmptyPage.StartAsync(o => o.Token = null);
        using HttpResponseMessage answer = await PostAsync(page, """{"command":"hold"}""");
        Assert.Equal(HttpStatusCode.Forbidden, answer.StatusCode);
        Assert.Empty(page.Operator.Given);
    }

    [Fact]
    public async Task Post_FromAnotherPage_IsRefused()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using HttpResponseMessage answer =
            await PostAsync(page, """{"command":"hold"}""", origin: "http://stranger.example");
        Assert.Equal(HttpStatusCode.Forbidden, answer.StatusCode);
        Assert.Empty(page.Operator.Given);
    }

    [Fact]
    public async Task Post_AsAFormOfAPage_IsRefused()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using HttpResponseMessage answer = await PostAsync(page, """{"command":"hold"}""", type: "text/plain");
        Assert.Equal(HttpStatusCode.UnsupportedMediaType, answer.StatusCode);
    }

    [Fact]
    public async Task Post_VehicleThatIsNotThere_IsRefused()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        using HttpResponseMessage answer = await PostAsync(page, """{"command":"hold","vehicle":1}""");
        Assert.Equal(HttpStatusCode.NotFound, answer.StatusCode);
    }

    [Theory]
    [InlineData(5000)]
    [InlineData(70_000)]
    [InlineData(2_000_000)]
    public async Task Post_BodyThatIsTooLong_IsRefused(int length)
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        try
        {
            using HttpResponseMessage answer = await PostAsync(page, new string(' ', length));
            Assert.Equal(HttpStatusCode.RequestEntityTooLarge, answer.StatusCode);
        }
        catch (HttpRequestException)
        {
            // The page closed before all of it was sent.
        }

        await EmptyPage.WaitAsync(
            () => page.Page.Counters.CommandsRefused + page.Page.Counters.RequestsRefused == 1);
        Assert.Empty(page.Operator.Given);
    }

    [Fact]
    public async Task Post_ManyAtOnce_AreNoMoreThanFiveASecond()
    {
        await using EmptyPage page = await EmptyPage.StartAsync();
        HttpResponseMessage[] answers =
            await Task.WhenAll(Enumerable.Range(0, 30).Select(_ => PostAsync(page, """{"command":"hold"}""")));
        int taken = answers.Count(a => a.StatusCode == HttpStatusCode.Accepted);
        Assert.InRange(taken, 5, 29);
        Assert.Equal(taken, page.Operator.Given.Count);
        Assert.Equal(30 - taken, answers.Count(a => a.StatusCode == HttpStatusCode.TooManyRequests));
        foreach (HttpResponseMessage answer in answers)
            answer.Dispose();
    }

    [Fact]
    public void TryTake_SixInASecond_LetsFiveThrough()
    {
        var time = new StoppedTime();
        var limit = new CommandLimit(time);
        for (int round = 0; round < 3; round++)
        {
            Assert.Equal(5, Enumerable.Range(0, 20).Count(_ => limit.TryTake()));
            time.Now += TimeSpan.FromSeconds(0.999);
            Assert.False(limit.TryTake());
            time.Now += TimeSpan.FromSeconds(0.001);
        }
    }

    private static async Task<HttpResponseMessage> PostAsync(
        EmptyPage page, string body, string? token = EmptyPage.Token, string path = "/command", string? origin = null,
        string type = "application/json")
    {
        using var request = new HttpRequestMessage(HttpMethod.Post, path);
        request.Content = new StringContent(body, Encoding.UTF8, type);
        if (token is not null)
            request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        if (origin is not null)
            request.Headers.Add("Origin", origin);
        return await page.Http.SendAsync(request);
    }

    private sealed class StoppedTime : TimeProvider
    {
        public TimeSpan Now { get; set; }

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;

        public override long GetTimestamp() => Now.Ticks;
    }
}
